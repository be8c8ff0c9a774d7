# Rack and pinion through one mesh cycle: share and pressure of a pair over its way through
# the mesh, way of the rack and stress in the fillets over the roll angle.

name   = 'gear_cycle'
height = 800
width  = 1200
load 'style.gnuplot'

# Columns of the summary: roll angle 2, shares 7 to 9, pressures 10 to 12 of the pairs 3 to 5,
# way 13, fillets of the pinion 14, where y is 16, of the rack 17.
cycle = folder . '/mesh_cycle/summary.csv'
set key autotitle columnhead

# Of pair k: its roll angle, and Hertz's pressure for a share there.
own(theta, k)   = theta + 18*(k - 4)
radius(theta)   = 17.1010 - 46.98463*theta*pi/180
hertz(share, a) = share > 0 && radius(a) > 0 ? 432.65*sqrt(17.1010/radius(a)*share) : NaN
found(value)    = value > 0 ? value : NaN

set multiplot layout 2,2
set lmargin 9
set rmargin 2
set xrange [-16:20]
set xtics 4
set xlabel 'roll angle of the pair, degrees' offset 0, 0.4

set title 'share of a pair' font ',13'
set yrange [0:1.1]
set key top right
set arrow 1 from -14.011, graph 0 to -14.011, graph 1 nohead dashtype 2 linecolor rgb '#808080'
set arrow 2 from 17.827, graph 0 to 17.827, graph 1 nohead dashtype 2 linecolor rgb '#808080'
set label 1 'rigid teeth' at -13.6, 0.72 textcolor rgb '#606060'
plot for [k=3:5] cycle using (own($2, k)):(column(4 + k)) with linespoints \
  linetype (k == 4 ? 1 : k == 3 ? 2 : 3) pointtype 7 pointsize 0.5 title sprintf('pair %d', k)
unset label 1

set title 'largest pressure of a pair, MPa' font ',13'
set yrange [0:900]
plot cycle using (own($2, 3)):(hertz($7, own($2, 3))) with lines linetype 1 title 'Hertz with the share found', \
  for [k=4:5] cycle using (own($2, k)):(hertz(column(4 + k), own($2, k))) with lines linetype 1 notitle, \
  for [k=3:5] cycle using (own($2, k)):(found(column(7 + k))) with points \
  linecolor rgb (k == 4 ? '#009e73' : k == 3 ? '#0072b2' : '#d55e00') pointtype 7 pointsize 0.6 title sprintf('pair %d', k)
unset arrow

set xrange [-10:10]
set xtics 2
set xlabel 'roll angle, degrees' offset 0, 0.4
set title 'way of the rack under its load, µm' font ',13'
set yrange [0:8]
unset key
plot cycle using 2:13 with linespoints linetype 1 pointtype 7 pointsize 0.5

set title 'largest tension in the fillets, MPa' font ',13'
set yrange [0:60]
set key top left
# Near the tip of the rack what is found at the end of the fillet belongs to the contact.
plot cycle using 2:($16 > 5.1 ? $14 : NaN) with linespoints linetype 2 pointtype 7 pointsize 0.5 title 'pinion', \
  cycle using 2:17 with linespoints linetype 3 pointtype 7 pointsize 0.5 title 'rack'
unset multiplot
