# Radial stress on the axis after the shot has left, over the yield stress, against the
# depth below the dent (figure 26 of Meguid & Czekanski). The waves are taken out.

name   = 'residual_stress'
height = 460
width  = 1100
load 'style.gnuplot'

R         = 0.5e-3
yield     = 600e6
axis(run) = folder . '/speed_and_hardening/' . run . '/axis.csv'

set multiplot layout 1,2
set lmargin 8
set rmargin 2
set xlabel 'depth/R' offset 0, 0.4
set ylabel 'radial stress / yield stress'
set xrange [0:3]
set yrange [-2.5:1]
set arrow from 0, 0 to 3, 0 nohead linecolor rgb '#808080'
set key bottom right

set title 'H = 1000 MPa' font ',13'
plot for [v in '50 75 100'] axis('v' . v . '_H1000') \
  using ($2/R):($3/yield) with linespoints pointtype 7 pointsize 0.4 title v . ' m/s'

set title '75 m/s' font ',13'
plot for [H in '20 1000 2000'] axis('v75_H' . H) \
  using ($2/R):($3/yield) with linespoints pointtype 7 pointsize 0.4 title 'H = ' . H . ' MPa'
unset multiplot
