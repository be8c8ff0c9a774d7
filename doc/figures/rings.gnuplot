# Contact pressure around rings that should press evenly: matching meshes, a press
# fit, and meshes that do not match. Angles by the position of the nodes.

name   = 'rings'
height = 420
width  = 850
load 'style.gnuplot'

angle(x, y) = (y < 0 ? 360 : 0) + 180/pi*atan2(y, x)
table(run)  = folder . '/' . run . '/outer.inner.csv'

set title 'Contact pressure around a ring in a ring' font ',13'
set lmargin 9
set rmargin 3
set key top right
set xlabel 'angle [degrees]' offset 0, 0.4
set ylabel 'pressure [MPa]'
set xrange [0:360]
set xtics 45
set yrange [0:40]
plot \
  21.1776 with lines linecolor rgb '#d55e00' linewidth 3 title 'gap closed by inner pressure, exact', \
  23.7417 with lines linecolor rgb '#0072b2' linewidth 3 title 'press fit, exact', \
  table('ring_in_ring') using (angle(column("x"), column("y"))):(1e-6*column("pressure")) with points linecolor black pointtype 7 pointsize 0.8 title '8 and 8 elements in 90 degrees', \
  table('press_fit') using (angle(column("x"), column("y"))):(1e-6*column("pressure")) with points linecolor black pointtype 5 pointsize 0.8 notitle, \
  table('clocked_rings') using (angle(column("x"), column("y"))):(1e-6*column("pressure")) with points linecolor black pointtype 6 pointsize 0.8 title '32 and 24 elements in 360 degrees'
