# Restitution of a rigid sphere on an elastic-plastic half space against its speed over
# that of first yield, beside the formulas of Johnson and Thornton.

name   = 'restitution'
height = 667
width  = 900
load 'style.gnuplot'

# R = 0.5 mm, 4.08407e-6 kg, E* = 200/0.91 GPa, Y = 600 MPa; first yield at 1.6 Y.
m  = 4.08407e-6
R  = 0.5e-3
Y  = 600e6
Es = 200e9/0.91
Vy = 3.194*sqrt((1.6*Y)**5*R**3/(Es**4*m))

johnson(x)  = 3.8*sqrt(Y/Es)*(m*(x*Vy)**2/(2*Y*R**3))**(-0.125)
thornton(x) = sqrt(1.2*sqrt(3))*sqrt(1 - 1/(6*x*x))*(1/(1 + 2*x*sqrt(1.2 - 0.2/(x*x))))**0.25

set title 'A rigid sphere bounces on an elastic-plastic half space' font ',13'
set lmargin 9
set rmargin 3
set logscale xy
set xrange [0.7:20000]
set yrange [0.08:1.2]
set ytics add (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1)
set xlabel 'speed / speed of first yield, 10.4 mm/s' offset 0, 0.4
set ylabel 'restitution'
set key bottom left Left reverse
set samples 400
# Johnson's formula is for flow that is complete; it passes 1 at 28 times first yield.
plot sample \
  [1:20000] thornton(x) with lines linetype 2 title 'Thornton: pressure at most 1.6 Y', \
  [28.5:20000] johnson(x) with lines linetype 3 title 'Johnson: mean pressure 3 Y, complete flow', \
  folder . '/restitution/summary.csv' using (column("speed [m/s]")/Vy):(column("restitution [1]")) \
    with points linetype 1 pointtype 7 pointsize 1 title 'computed'
