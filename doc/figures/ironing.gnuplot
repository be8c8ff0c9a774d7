# Forces of the ironing block against time: the slab's surface as a spline, as facets.

name   = 'ironing'
height = 480
width  = 850
load 'style.gnuplot'

set multiplot layout 2, 1 title 'Shallow ironing: forces on the slab' font ',13' \
  margins 0.08, 0.97, 0.11, 0.86 spacing 0.06
set xrange [1:2]
set key at graph 0.99, graph 1.22 right top horizontal Left reverse
set ylabel 'horizontal [N]'
set yrange [0:10]
set ytics 5
set format x ''
plot \
  history('ironing_facets') using 1:(column("block.foot.force_x [N]")) with lines linetype 3 title 'facets', \
  history('ironing') using 1:(column("block.foot.force_x [N]")) with lines linetype 1 title 'spline'
unset key
set format x
set xlabel 'time [s], 10 mm/s' offset 0, 0.4
set ylabel 'vertical [N]'
set yrange [0:30]
set ytics 10
plot \
  history('ironing_facets') using 1:(-column("block.foot.force_y [N]")) with lines linetype 3 title 'facets', \
  history('ironing') using 1:(-column("block.foot.force_y [N]")) with lines linetype 1 title 'spline'
unset multiplot
