# Finger joint: pressure against thickness, load and flexion, friction torque.

name   = 'finger_joint'
height = 760
load 'style.gnuplot'

curves  = folder . '/finger_joint_curves.csv'
layer   = folder . '/layer/summary.csv'
flexion = folder . '/flexion/summary.csv'
run(r)  = folder . '/flexion/' . r . '/history.csv'

set multiplot layout 2,2 title 'A metal head in a polyethylene cup: R = 5 mm, clearance 0.1 mm' font ',13'
set key top right

set xlabel 'thickness of the polyethylene [mm]'
set ylabel 'largest pressure [MPa], 100 N'
set logscale x
set xtics (0.5, 1, 2, 4, 8, 16)
set xrange [0.4:16]
set yrange [0:9]
plot curves index 0 using 1:4 with lines linetype 2 title 'series', \
     '' index 0 using 1:6 with lines linetype 1 dashtype 2 title 'Hertz', \
     '< grep ^thickness ' . layer . ' | sed "s/^thickness_//"' using 1:9 with points linetype 3 pointtype 7 title 'computed'

set xlabel 'load [N]'
set ylabel 'largest pressure [MPa], 3 mm'
set xtics (10, 30, 100, 300)
set xrange [8:600]
set yrange [0:15]
set key top left
plot curves index 1 using 2:4 with lines linetype 2 title 'series', \
     '' index 1 using 2:6 with lines linetype 1 dashtype 2 title 'Hertz', \
     '< grep ^load ' . layer . ' | sed "s/^load_//"' using 1:9 with points linetype 3 pointtype 7 title 'computed'

unset logscale x
set xlabel 'flexion [degrees]'
set ylabel 'largest pressure [MPa], 100 N'
set xtics autofreq 15
set xrange [30:90]
set yrange [4:8]
angle(t) = 30 + 60*(1 - abs(t - 1.2))
plot run('base')   using ($1 > 0.21 ? angle($1) : NaN):(1e-6*column("head.pressure_max [Pa]")) with lines linetype 2 title 'cup to 70 degrees', \
     run('arc_60') using ($1 > 0.21 ? angle($1) : NaN):(1e-6*column("head.pressure_max [Pa]")) with lines linetype 3 title '60 degrees', \
     run('arc_55') using ($1 > 0.21 ? angle($1) : NaN):(1e-6*column("head.pressure_max [Pa]")) with lines linetype 4 title '55 degrees'

set xlabel 'friction coefficient'
set ylabel 'friction torque [N mm], 100 N'
set xtics autofreq 0.04
set xrange [0:0.18]
set yrange [0:90]
plot 100*5.05*1.0093*x/sqrt(1 + x**2) with lines linetype 2 title '{/Symbol m}F(R + c/2) k/{/Symbol \326}(1 + {/Symbol m}^2)', \
     '< grep ^mu ' . flexion . ' | sed "s/^mu_//"' using 1:13 with points linetype 3 pointtype 7 title 'computed'
unset multiplot
