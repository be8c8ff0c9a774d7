# The contact patch test on meshes of 3 and 4 elements: pressure at the nodes with the
# mortar constraint and with the gap of each node; and the slit ring that closes.

name   = 'patch_test'
height = 380
width  = 850
load 'style.gnuplot'

set multiplot layout 1, 2
set title 'Contact patch test' font ',13'
set lmargin 9
set rmargin 2
set key bottom right
set xlabel 'x [m]' offset 0, 0.4
set ylabel 'pressure over the exact one'
set xrange [-0.05:1.05]
set yrange [0.9:1.1]
plot 1 with lines linecolor rgb '#d55e00' linewidth 3 title 'exact', \
  folder . '/patch_test/lower.top.csv' using (column("x")):(1e-5*column("pressure")) with linespoints linecolor black pointtype 7 title 'mortar', \
  folder . '/nodes/patch_test/lower.top.csv' using (column("x")):(1e-5*column("pressure")) with linespoints linecolor black pointtype 6 dashtype 2 title 'node to surface'
set title 'A slit ring closes on itself'
set key top left
set xlabel 'load, share of the largest' offset 0, 0.4
set ylabel 'contact force [N per metre of width]'
set xrange [0:1]
set yrange [0:450]
plot (x > 0.5 ? 790.12*x - 395.06 : 0) with lines linecolor rgb '#d55e00' linewidth 3 title 'curved bar', \
  history('slit_ring') using (column("time [s]")):(abs(column("ring.end.force_y [N]"))) with points linecolor black pointtype 7 title 'computed'
unset multiplot
