# Fir-tree joint spun up and back with friction: shear on the lowest flank, displacement of the top
# over the square of the speed, and work of friction.

name   = 'fir_tree_cycle'
height = 400
width  = 1200
load 'style.gnuplot'

study    = folder . '/fir_tree_studies/spin_up_and_back/'
run(name) = study . name . '/history.csv'
alpha = 25*pi/180
rpm(t)   = 9000*(t < 1 ? t : 2 - t)
share(t) = (t < 1 ? t : 2 - t)
# Along the flank, MPa: the force over its 3 mm.
shear(x, y) = (x*cos(alpha) - y*sin(alpha))/0.003/1e6

set tics font ',10'
set key font ',10'
set xlabel font ',11'
set ylabel font ',11'
set multiplot layout 1, 3 margins 0.08, 0.985, 0.14, 0.9 spacing 0.08, 0.1
set xlabel 'speed [rpm]' offset 0, 0.4
set ylabel 'mean shear stress [MPa]'
set xrange [0:9000]
set xtics 3000
set yrange [-75:125]
set key top left Left reverse
set title 'Lowest flank, elastic' font ',13'
plot for [i = 1:3] run('elastic_mu_' . word('0 0.1 0.5', i)) \
  using (rpm($1)):(shear(column('disc.contact_3.force_x [N]'), column('disc.contact_3.force_y [N]'))) \
  with lines linetype i title 'friction ' . word('0 0.1 0.5', i)

set ylabel 'displacement / (speed/9000 rpm)² [µm]'
set yrange [275:300]
set title 'Top of the root, elastic' font ',13'
plot for [i = 1:3] run('elastic_mu_' . word('0 0.1 0.5', i)) \
  using (rpm($1)):(share($1) > 0.05 ? 1e6*column('top.displacement_y [m]')/share($1)**2 : NaN) \
  with lines linetype i title 'friction ' . word('0 0.1 0.5', i)

set ylabel 'work of friction [J/m]'
set yrange [0:12]
set title 'Work of friction, elastic' font ',13'
plot for [i = 2:3] run('elastic_mu_' . word('0 0.1 0.5', i)) \
  using (rpm($1)):(column('energy.friction [J]')) with lines linetype i title 'friction ' . word('0 0.1 0.5', i)
unset multiplot
