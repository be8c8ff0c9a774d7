# Fir-tree joint with one to five teeth: the force of each tooth, and the largest stresses.

name   = 'fir_tree_teeth'
height = 460
width  = 1100
load 'style.gnuplot'

teeth(n) = folder . '/fir_tree_studies/teeth/n_' . n
array force[36]
do for [n = 1:5] {
  do for [k = 1:n] {
    stats teeth(n) . '/history.csv' using (-1e-6*column('disc.contact_' . k . '.force_y [N]')) nooutput
    force[6*n + k] = STATS_max
  }
}

set multiplot layout 1,2
set lmargin 8
set rmargin 2
set xlabel 'tooth, 1 at the rim' offset 0, 0.4
set ylabel 'force [MN/m]'
set xrange [0.7:5.3]
set yrange [0:1.5]
set xtics 1
set key top right
set title 'Force of each tooth' font ',13'
plot for [n = 1:5] '+' using ($0 + 1):(force[6*n + $0 + 1]) every ::0::(n - 1) \
  with linespoints linetype n pointtype 7 pointsize 0.8 title (n == 1 ? 'one tooth' : sprintf('%d teeth', n))

summary = folder . '/fir_tree_studies/teeth/summary.csv'
set xlabel 'teeth'
set ylabel 'stress [MPa]'
set yrange [0:2200]
set title 'Largest stresses at full speed' font ',13'
plot summary using 2:(column('disc von Mises [MPa]')) with linespoints linetype 1 pointtype 7 title 'von Mises, disc', \
  summary using 2:(column('blade notch 1 [MPa]')) with linespoints linetype 2 pointtype 7 title 'tension in the top fillet of the blade', \
  summary using 2:(column('mean pressure 1 [MPa]')) with linespoints linetype 3 pointtype 7 title 'mean pressure of the top flank'
unset multiplot
