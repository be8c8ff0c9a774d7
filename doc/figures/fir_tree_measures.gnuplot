# Fir-tree joint: what flank length, contact angle, angle of the back flank and wedge angle do to
# the shares of the teeth (above) and to the stresses (below).

name   = 'fir_tree_measures'
height = 520
width  = 1200
load 'style.gnuplot'

summary(study) = folder . '/fir_tree_studies/' . study . '/summary.csv'
array study[4]  = ['flank_length', 'contact_angle', 'back_flank_angle', 'taper_angle']
array label[4]  = ['flank length [mm]', 'contact angle [degrees]', 'back flank angle [degrees]', 'wedge angle [degrees]']
array factor[4] = [1e3, 1, 1, 1]

set multiplot layout 2, 4 margins 0.06, 0.985, 0.11, 0.96 spacing 0.05, 0.12
set tics font ',10'
set key font ',10'
set xlabel font ',11'
set ylabel font ',11'
set yrange [20:50]
set ytics 10
do for [i = 1:4] {
  if (i == 1) { set ylabel 'share of the force [%]' offset 1.2, 0; set key at graph 0.68, 0.99 } else { unset ylabel; unset key }
  plot for [k = 1:3] summary(study[i]) using (factor[i]*$2):(column('share ' . k . ' [%]')) \
    with linespoints linetype k pointtype 7 pointsize 0.7 title sprintf('tooth %d', k)
}
set yrange [0:1600]
set ytics 400
do for [i = 1:4] {
  set xlabel label[i] offset 0, 0.5
  if (i == 1) { set ylabel 'stress [MPa]' offset 1.2, 0; set key at graph 1.02, 0.7 } else { unset ylabel; unset key }
  plot summary(study[i]) using (factor[i]*$2):(column('disc von Mises [MPa]')) with linespoints linetype 1 pointtype 7 pointsize 0.7 title 'von Mises, disc', \
    summary(study[i]) using (factor[i]*$2):(column('blade notch 3 [MPa]')) with linespoints linetype 2 pointtype 7 pointsize 0.7 title 'tension, blade', \
    summary(study[i]) using (factor[i]*$2):(column('mean pressure 3 [MPa]')) with linespoints linetype 3 pointtype 7 pointsize 0.7 title 'pressure, flank 3'
}
unset multiplot
