# Forces of shallow ironing against time: the foot as a spline, as facets, and what six
# other codes found (Fischer & Wriggers 2006, Hartmann, Yastrebov, Poulios & Renard,
# Code_Aster, solids4foam).

name   = 'shallow_ironing'
height = 560
width  = 900
load 'style.gnuplot'

# Time, horizontal, vertical.
$published << EOD
1.5, 102, 337
1.5, 171, 360
1.5, 189, 365
1.5, 123, 395
1.5, 160, 408
1.5, 143, 421
EOD
# Time, lowest, change of time, height.
$pressed << EOD
1, 268, 0, 64
EOD

set multiplot layout 2, 1 title 'Shallow ironing: forces on the slab' font ',13' \
  margins 0.08, 0.97, 0.1, 0.87 spacing 0.06
set xrange [0:2]
set xtics 0.25
set key at graph 0.99, graph 1.19 right top horizontal Left reverse
set ylabel 'horizontal [N]'
set yrange [0:250]
set ytics 50
set format x ''
plot \
  history('facets') using 1:(column("block.foot.force_x [N]")) with lines linetype 3 title 'facets', \
  history('shallow_ironing') using 1:(column("block.foot.force_x [N]")) with lines linetype 1 title 'spline', \
  $published using 1:2 with points linetype 2 pointtype 6 pointsize 1.1 title 'published'
unset key
set format x '%g'
set xlabel 'time [s]: down 1 mm, then along 10 mm' offset 0, 0.4
set ylabel 'vertical [N]'
set yrange [0:450]
set ytics 100
plot \
  history('facets') using 1:(-column("block.foot.force_y [N]")) with lines linetype 3 title 'facets', \
  history('shallow_ironing') using 1:(-column("block.foot.force_y [N]")) with lines linetype 1 title 'spline', \
  $pressed using 1:2:3:4 with vectors nohead linetype 2 linewidth 4 title '', \
  $published using 1:3 with points linetype 2 pointtype 6 pointsize 1.1 title ''
unset multiplot
