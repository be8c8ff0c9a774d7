# Way of the disc's centre and angle times radius against time, rolling and sliding.

name   = 'rolling_disc'
height = 430
width  = 850
load 'style.gnuplot'

s   = 0.3420201433
c   = 0.9396926208
g   = 9.81
R   = 0.05
way = 'column("disc.displacement_x [m]")'
arc = '(-R*column("disc.angle [rad]"))'

set multiplot layout 1, 2 title 'A rigid disc on an elastic slope of 20 degrees' font ',13' \
  margins 0.08, 0.97, 0.14, 0.82 spacing 0.08
set key at graph 0.02, graph 0.97 left top Left reverse
set xlabel 'time [s]' offset 0, 0.4
set ylabel 'way, angle times R [mm]'
set xrange [0:0.2]
set yrange [0:60]
set xtics 0.05
set title 'rolling, {/Symbol m} = 0.2'
plot \
  1e3*g*s*x**2/3 with lines linecolor rgb '#d55e00' linewidth 5 title 'exact, both', \
  history('rolling_disc') using 1:(1e3*@way) with lines linetype 1 title 'way', \
  history('rolling_disc') using 1:(1e3*@arc) with lines linetype 2 dashtype 2 title 'angle times R'
unset ylabel
set title 'sliding, {/Symbol m} = 0.08'
plot \
  1e3*g*(s - 0.08*c)*x**2/2 with lines linecolor rgb '#d55e00' linewidth 5 title 'exact', \
  1e3*g*0.08*c*x**2 with lines linecolor rgb '#d55e00' linewidth 5 notitle, \
  history('sliding') using 1:(1e3*@way) with lines linetype 1 title 'way', \
  history('sliding') using 1:(1e3*@arc) with lines linetype 2 dashtype 2 title 'angle times R'
unset multiplot
