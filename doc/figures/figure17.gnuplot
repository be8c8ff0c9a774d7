# Figure 17 of Meguid & Czekanski: normalised displacement of the tip against time.

name   = 'figure17'
height = 620
load 'style.gnuplot'

tip = 'column("tip.displacement_y [m]")/deflection'
set multiplot

set title 'Cantilever beam striking a rigid floor: the tip' font ',17'
set size 1, 0.56
set origin 0, 0.44
set xlabel 'time [ms]' offset 0, 0.4
set ylabel "tip displacement /\nstatic deflection" offset 0.5
set xrange [0:6]
set yrange [-1.4:0.1]
set ytics 0.5
set lmargin 9
set rmargin 3
set bmargin 5.2
set key at screen 0.54, screen 0.455 center center horizontal Left reverse maxrows 2
set arrow 1 from graph 0, first -1 to graph 1, first -1 nohead linecolor rgb '#808080' dashtype 3
set label 1 'floor' at graph 0.005, first -1.09 textcolor rgb '#606060'
plot \
  history('penalty_1') using (1e3*$1):(@tip) with lines linetype 5 title 'penalty, k_N / k_{beam} = 1', \
  history('penalty_10') using (1e3*$1):(@tip) with lines linetype 4 title 'penalty, 10', \
  history('penalty_100') using (1e3*$1):(@tip) with lines linetype 3 title 'penalty, 100', \
  history('penalty_1000') using (1e3*$1):(@tip) with lines linetype 2 title 'penalty, 1000', \
  history('cantilever_beam') using (1e3*$1):(@tip) with lines linetype 1 title 'variational inequality'

set title 'The first bounce, close to the floor'
set size 1, 0.44
set origin 0, 0
unset key
set bmargin 3
set xrange [0.56:1.14]
set yrange [-1.33:-0.95]
set ytics 0.1
set label 1 at graph 0.005, first -1.025
replot
unset multiplot
