# Velocity of the shot and contact force against time (figure 25 of Meguid & Czekanski).

name   = 'shot_peening'
height = 620
width  = 850
load 'style.gnuplot'

impact = folder . '/speed_and_hardening/v75_H1000/history.csv'

set multiplot layout 2,1 title 'A shot of 75 m/s strikes a target, H = 1000 MPa' font ',13'
set lmargin 10
set rmargin 3
set xrange [0:2]

set ylabel 'velocity [m/s]'
set yrange [-80:30]
set ytics 20
set arrow 1 from 1.25, graph 0 to 1.25, graph 1 nohead linecolor rgb '#808080' dashtype 3
set arrow 2 from 1.70, graph 0 to 1.70, graph 1 nohead linecolor rgb '#808080' dashtype 3
set label 1 'paper: at rest' at 1.24, graph 0.1 right textcolor rgb '#606060'
set label 2 'paper: leaves' at 1.71, graph 0.1 left textcolor rgb '#606060'
set arrow 3 from 1.70, 17.3 to 2, 17.3 nohead linecolor rgb '#808080' dashtype 3
set label 3 'paper: 17.3 m/s' at 1.71, 24 left textcolor rgb '#606060'
plot impact using (1e6*$1):(column("shot.velocity_y [m/s]")) with lines linetype 2 notitle

unset label
unset arrow 3
set xlabel 'time [{/Symbol m}s]' offset 0, 0.4
set ylabel 'contact force [N]'
set yrange [0:420]
set ytics 100
plot impact using (1e6*$1):(-column("shot.force_y [N]")) with lines linetype 3 notitle
unset multiplot
