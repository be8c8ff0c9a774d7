# Contact force of the bouncing ball against time, beside Hertz.

name   = 'hertz_bounce'
height = 430
width  = 850
load 'style.gnuplot'

# Hertz: approach s times the largest one after the time T(s), with the force F s^(3/2).
# T = a/v times the integral of ds/sqrt(1 - s^(5/2)), here over w = sqrt(1 - s)
F        = 145.179
duration = 82.798
unit     = 2.81314/0.1
n        = 200
f(w)     = 2*w/sqrt(1 - (1 - w*w)**2.5)
low(s)   = sqrt(1 - s)
T(s)     = s >= 1 ? duration/2 : unit*(1 - low(s))/n*(sum [i=1:n] f(low(s) + (i - 0.5)*(1 - low(s))/n))

set title 'A steel ball bounces on a rigid plane' font ',13'
set parametric
set trange [0:1]
set samples 200
set lmargin 9
set rmargin 3
set key at graph 0.5, graph 0.3 center center Left reverse
set xlabel 'time [{/Symbol m}s]' offset 0, 0.4
set ylabel 'contact force [N]'
set xrange [0:100]
set yrange [0:160]
set arrow 1 from duration, graph 0 to duration, graph 0.35 nohead linecolor rgb '#808080' dashtype 3
set label 1 '82.798 {/Symbol m}s' at duration, graph 0.39 center textcolor rgb '#606060'
set arrow 2 from graph 0, first F to graph 1, first F nohead linecolor rgb '#808080' dashtype 3
set label 2 '145.179 N' at graph 0.99, first F + 6 right textcolor rgb '#606060'
plot \
  T(t), F*t**1.5 with lines linecolor rgb '#d55e00' linewidth 5 title 'Hertz', \
  duration - T(t), F*t**1.5 with lines linecolor rgb '#d55e00' linewidth 5 notitle, \
  history('hertz_bounce') using (1e6*$1):(column("floor.force_y [N]")) with lines linetype 1 title 'computed'
