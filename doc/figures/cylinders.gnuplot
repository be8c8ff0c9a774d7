# Pressure and shear along the contact of two half cylinders, beside Hertz and
# Cattaneo & Mindlin for the forces found.

name   = 'cylinders'
height = 420
width  = 850
load 'style.gnuplot'

table  = folder . '/cattaneo_mindlin/lower.rim.csv'
R      = 0.005
E      = 115.3846e9
mu     = 0.5
stats history('cattaneo_mindlin') using (column("lower.rim.force_y [N]")) nooutput
P      = STATS_max
stats history('cattaneo_mindlin') using (-column("lower.rim.force_x [N]")) nooutput
Q      = STATS_max
a      = sqrt(4*P*R/(pi*E))
p0     = sqrt(P*E/(pi*R))
c      = a*sqrt(1 - Q/(mu*P))
root(x, b) = abs(x) < b ? sqrt(1 - (x/b)**2) : 0
pressure(x) = p0*root(x, a)
shear(x)    = mu*p0*(root(x, a) - c/a*root(x, c))

set title 'Two half cylinders, pressed and sheared' font ',13'
set samples 801
set lmargin 9
set rmargin 3
set key top right
set xlabel 'x [{/Symbol m}m]' offset 0, 0.4
set ylabel 'GPa'
set xrange [-260:260]
set yrange [0:2.6]
plot \
  1e-9*pressure(1e-6*x) with lines linecolor rgb '#d55e00' linewidth 4 title 'pressure, Hertz', \
  1e-9*shear(1e-6*x) with lines linecolor rgb '#0072b2' linewidth 4 title 'shear, Cattaneo and Mindlin', \
  table using (1e6*column("x")):(1e-9*column("pressure")) with points linecolor black pointtype 7 pointsize 0.7 title 'computed', \
  table using (1e6*column("x")):(1e-9*abs(column("shear"))) with points linecolor black pointtype 6 pointsize 0.8 notitle
