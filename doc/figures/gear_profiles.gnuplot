# Way of the rack over the roll angle with tip relief and with profile shift.

name   = 'gear_profiles'
height = 460
width  = 1100
load 'style.gnuplot'

# Columns of the summary: roll angle 2, way 19.
rows(variant) = sprintf('< grep "^%s_" %s', variant, folder . '/profiles/summary.csv')

set multiplot layout 1,2
set lmargin 8
set rmargin 2
set xrange [-9:9]
set xtics 3
set yrange [0:9]
set xlabel 'roll angle, degrees' offset 0, 0.4
set ylabel 'way of the rack, µm' offset 1, 0
set key bottom left

set title 'tip relief' font ',13'
plot rows('none') using 2:19 with linespoints linetype 1 pointtype 7 pointsize 0.5 title 'none', \
  rows('short_4') using 2:19 with linespoints linetype 2 pointtype 7 pointsize 0.5 title '4 µm, short', \
  rows('short_7') using 2:19 with linespoints linetype 3 pointtype 7 pointsize 0.5 title '7 µm, short', \
  rows('long_4') using 2:19 with linespoints linetype 4 pointtype 7 pointsize 0.5 title '4 µm, long', \
  rows('long_7') using 2:19 with linespoints linetype 5 pointtype 7 pointsize 0.5 title '7 µm, long'

set title 'profile shift' font ',13'
plot rows('none') using 2:19 with linespoints linetype 1 pointtype 7 pointsize 0.5 title 'none', \
  rows('shift_0\.25') using 2:19 with linespoints linetype 2 pointtype 7 pointsize 0.5 title '0.25 modules', \
  rows('shift_0\.5') using 2:19 with linespoints linetype 3 pointtype 7 pointsize 0.5 title '0.5 modules'
unset multiplot
