# Velocity of the braking block and of the block that sticks and slips, beside those of a
# rigid block.

name   = 'friction_blocks'
height = 480
width  = 850
load 'style.gnuplot'

g = 9.81
# Pushed with 2 g t up to g/2, breaks loose at 0.2 s, kinetic friction 0.3 g; released
# at 0.5 s
ramp(t)    = g*(t**2 - 0.04 - 0.3*(t - 0.2))
plateau(t) = ramp(0.25) + 0.2*g*(t - 0.25)
coast(t)   = plateau(0.5) - 0.3*g*(t - 0.5)
pushed(t)  = t < 0.2 ? 0 : t < 0.25 ? ramp(t) : t < 0.5 ? plateau(t) : coast(t) > 0 ? coast(t) : 0
braked(t)  = 1 - 0.3*g*t > 0 ? 1 - 0.3*g*t : 0

set multiplot layout 1, 2 title 'Blocks with friction: velocity' font ',13' \
  margins 0.08, 0.97, 0.13, 0.84 spacing 0.08
set samples 800
set key at graph 0.99, graph 0.97 right top Left reverse
set xlabel 'time [s]' offset 0, 0.4
set ylabel 'velocity [m/s]'
set ytics 0.2
set title 'braked, {/Symbol m} = 0.3'
set xrange [0:0.6]
set yrange [-0.1:1.1]
plot \
  braked(x) with lines linecolor rgb '#d55e00' linewidth 5 title 'rigid block', \
  history('braking_block') using 1:(column("foot.velocity_x [m/s]")) with lines linetype 1 title 'foot of the elastic block'
unset ylabel
set title 'pushed and released, {/Symbol m} = 0.4 at rest, 0.3 in motion'
set xrange [0:0.8]
set yrange [-0.05:0.75]
plot \
  pushed(x) with lines linecolor rgb '#d55e00' linewidth 5 title 'rigid block', \
  history('stick_slip') using 1:(column("centre.velocity_x [m/s]")) with lines linetype 1 title 'centre of the elastic block'
unset multiplot
