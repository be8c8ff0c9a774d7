# Error of the largest pressure of one pair of teeth against the number of unknowns: all cells
# refined, those that the program chooses, and the submodel with its global run.

name   = 'gear_convergence'
height = 480
width  = 900
load 'style.gnuplot'

hertz  = 432.65e6
error(p) = 100*abs(p/hertz - 1)
meshes(run) = folder . '/convergence/' . run . '/meshes.csv'
set xlabel 'unknowns'
set ylabel 'error of the largest pressure [%]'
set logscale xy
set xrange [1000:3e6]
set yrange [0.01:100]
set format x '10^{%T}'
set key right bottom Left reverse
plot 2 with lines linewidth 1 linecolor rgb '#999999' dashtype 2 title '2 %', \
  meshes('uniform') using 3:(error($5)) with linespoints linetype 1 pointtype 7 pointsize 0.8 title 'all cells', \
  meshes('adaptive') using 3:(error($5)) with linespoints linetype 2 pointtype 7 pointsize 0.8 title 'refined by the program', \
  meshes('uniform_curved') using 3:(error($5)) with linespoints linetype 1 pointtype 6 pointsize 0.8 dashtype 2 title 'biquadratic, all cells', \
  meshes('adaptive_curved') using 3:(error($5)) with linespoints linetype 2 pointtype 6 pointsize 0.8 dashtype 2 title 'biquadratic, refined by the program', \
  folder . '/submodel/meshes.csv' using ($3 + 14010):(error($5)) with linespoints linetype 3 pointtype 6 pointsize 0.8 title 'submodel and its global run'
