# Pressure under an elastic half ball on a rigid plane, beside Hertz for the force found.

name   = 'hertz_sphere'
height = 420
width  = 850
load 'style.gnuplot'

table = folder . '/hertz_sphere/plate.csv'
R     = 0.01
E     = 210e9/(1 - 0.3**2)
stats history('hertz_sphere') using (column("plate.force_y [N]")) nooutput
P     = STATS_max
a     = (3*P*R/(4*E))**(1./3)
p0    = 3*P/(2*pi*a**2)
pressure(x) = abs(x) < a ? p0*sqrt(1 - (x/a)**2) : 0

set title sprintf('A steel ball of 10 mm radius pressed on a plane with %.1f N', P) font ',13'
set samples 801
set lmargin 9
set rmargin 3
set key top right
set xlabel 'distance from the axis [{/Symbol m}m]' offset 0, 0.4
set ylabel 'pressure [GPa]'
set xrange [0:200]
set yrange [0:2.4]
plot \
  1e-9*pressure(1e-6*x) with lines linecolor rgb '#d55e00' linewidth 4 title 'Hertz', \
  table using (1e6*column("x")):(1e-9*column("pressure")) with points linecolor black pointtype 7 pointsize 0.7 title 'computed, bilinear elements', \
  folder . '/quadratic/hertz_sphere/plate.csv' using (1e6*column("x")):(1e-9*column("pressure")) with points linecolor rgb '#0072b2' pointtype 6 pointsize 0.9 title 'biquadratic, mortar'
