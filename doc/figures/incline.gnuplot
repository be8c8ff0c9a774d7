# Way of a block on an incline of 30 degrees, with two coefficients of friction.

name   = 'incline'
height = 420
width  = 850
load 'style.gnuplot'

# g (sin 30 - 0.2 cos 30)
acceleration = 3.205858

set title 'A block on an incline of 30 degrees' font ',13'
set lmargin 9
set rmargin 3
set key top left Left reverse
set xlabel 'time [s]' offset 0, 0.4
set ylabel 'way [m]'
set xrange [0:1.02]
set yrange [-0.1:1.7]
plot \
  acceleration*x**2/2 with lines linecolor rgb '#d55e00' linewidth 4 title 'rigid block, {/Symbol m} = 0.2', \
  0 with lines linecolor rgb '#0072b2' linewidth 4 title 'rigid block, {/Symbol m} = 0.6 > tan 30', \
  history('incline') using 1:(sqrt(column("centre.displacement_x [m]")**2 + column("centre.displacement_y [m]")**2)) every 50 with points linecolor black pointtype 7 pointsize 0.7 title 'computed', \
  history('incline_stick') using 1:(sqrt(column("centre.displacement_x [m]")**2 + column("centre.displacement_y [m]")**2)) every 50 with points linecolor black pointtype 7 pointsize 0.7 notitle
