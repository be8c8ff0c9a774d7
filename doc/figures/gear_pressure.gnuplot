# Pressure along the flank of the rack where teeth touch, as in figure 20 of Meguid &
# Czekanski: R1 at or next to the pitch point, R2 past the start of contact. Lines: Hertz with
# the share found.

name   = 'gear_pressure'
height = 460
width  = 1100
load 'style.gnuplot'

one   = folder . '/rack_and_pinion/rack.right_2.csv'
start = folder . '/start_of_contact/'

# Distance from where rigid teeth touch, along the flank towards the tip of the rack, in mm.
# y is that of a contactor node, s the place of the contact on the line of action, in mm.
along(y, s) = (1e3*y - s*sin(20*pi/180))/cos(20*pi/180)

# Hertz, F being the load of the pair along the rack, in kN/m = N/mm.
peak(s, F)     = 432.65*sqrt(17.1010/(17.1010 - s)*F/90)
half(s, F)     = 2*F/cos(20*pi/180)/(pi*peak(s, F))
hertz(x, s, F) = abs(x) < half(s, F) ? peak(s, F)*sqrt(1 - (x/half(s, F))**2) : NaN

# Loads of the pairs 3 and 4 as found, columns 6 and 13 of the history
stats start . 'history.csv' using (abs($6)*1e-3) every ::1 name 'pair3' nooutput
stats start . 'history.csv' using (abs($13)*1e-3) every ::1 name 'pair4' nooutput

set samples 2000
set multiplot layout 1,2
set lmargin 8
set rmargin 2
set ylabel 'pressure, MPa' offset 1, 0
set xlabel 'along the flank towards the tip of the rack, mm' offset 0, 0.4

set title 'R1: one pair at the pitch point; two pairs, 3.4 mm past it' font ',13'
set xrange [-0.2:0.2]
set yrange [0:500]
set key top left
plot one using (along($2, 0)):($4 > 0 ? $4*1e-6 : NaN) with points linetype 2 pointtype 7 pointsize 0.6 title 'one pair', \
  hertz(x, 0, 90) with lines linetype 2 notitle, \
  start . 'pinion.right_4.csv' using (along($2, 3.36215)):($4 > 0 ? $4*1e-6 : NaN) with points linetype 3 pointtype 7 pointsize 0.6 title 'two pairs', \
  hertz(x, 3.36215, pair4_max) with lines linetype 3 notitle

set title 'R2: two pairs, past the start of contact' font ',13'
set key top right
corner = along(-3.9507e-3, -11.39851)
set arrow from corner, graph 0 to corner, graph 1 nohead dashtype 2 linecolor rgb '#808080'
set label 'corner of the tip' at corner - 0.006, 30 rotate by 90 textcolor rgb '#606060'
plot start . 'rack.right_3.csv' using (along($2, -11.39851)):($4 > 0 ? $4*1e-6 : NaN) with linespoints linetype 3 pointtype 7 pointsize 0.6 title 'two pairs', \
  hertz(x, -11.39851, pair3_max) with lines linetype 1 title 'Hertz, flank without an end'
unset multiplot
