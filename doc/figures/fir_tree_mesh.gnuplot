# Fir-tree joint on several meshes: the largest pressure at the lower end of the lowest flank against
# the elements there, the stress in the fillet below, and the pressure where meshes do not match.

name   = 'fir_tree_mesh'
height = 400
width  = 1200
load 'style.gnuplot'

study   = folder . '/fir_tree_studies/mesh'
summary = study . '/summary.csv'
x0 = 7.692858
l  = 3*cos(25*pi/180)
along(x) = (1e3*x - x0)/l
# Elements of 0.375 mm, cut in half K times.
edge(name) = 375/2**real(name[6:6])
linear(name) = 375/2**real(name[8:8])
is_arcs(name)  = strlen(name) == 6 && name[1:4] eq 'edge'
is_flanks(name) = strlen(name) == 13 && name[1:4] eq 'edge'
is_linear(name) = strlen(name) == 8 && name[1:6] eq 'linear'

set tics font ',10'
set key font ',10'
set xlabel font ',11'
set ylabel font ',11'
set multiplot layout 1, 3 margins 0.08, 0.985, 0.14, 0.9 spacing 0.08, 0.1
set logscale xy
set xlabel 'element [µm]' offset 0, 0.4
set ylabel 'largest pressure [MPa]'
set xrange [2:300]
set yrange [300:20000]
set key top right
set title 'Lower end of the lowest flank' font ',13'
plot summary using (is_flanks(strcol(1)) ? edge(strcol(1)) : NaN):(column('pressure 3 [MPa]')) with linespoints linetype 3 pointtype 7 title 'flanks alone in contact', \
  summary using (is_arcs(strcol(1)) ? edge(strcol(1)) : NaN):(column('pressure 3 [MPa]')) with linespoints linetype 1 pointtype 7 title 'flanks and the arcs beside them', \
  1145.72*sqrt(187.5/x) with lines linetype 2 dashtype 2 title '1/sqrt(element)'

unset logscale y
set xrange [30:500]
set yrange [1150:1250]
set ytics 25
set ylabel 'von Mises [MPa]'
set key bottom left
set title 'Fillet of the disc below it' font ',13'
plot summary using (is_linear(strcol(1)) ? linear(strcol(1)) : NaN):(column('disc von Mises [MPa]')) with linespoints linetype 1 pointtype 7 title 'bilinear', \
  summary using (strcol(1) eq 'quadratic_0' ? 375 : strcol(1) eq 'quadratic_1' ? 187.5 : NaN):(column('disc von Mises [MPa]')) with linespoints linetype 3 pointtype 7 title 'biquadratic'

unset logscale x
set xlabel 'place on the flank, upper to lower end'
set ylabel 'pressure [MPa]'
set xrange [0:1.02]
set yrange [0:1000]
set ytics 250
set key top center
set title 'Meshes that do not match' font ',13'
plot study . '/quadratic_0/disc.contact_3.csv' using (along(column('x'))):(column('pressure') > 0 ? column('pressure')/1e6 : NaN) with lines linetype 1 title 'they match', \
  study . '/disc_11_cells/disc.contact_3.csv' using (along(column('x'))):(column('pressure') > 0 ? column('pressure')/1e6 : NaN) with linespoints linetype 3 pointtype 7 pointsize 0.5 title '8 and 11 cells', \
  study . '/disc_11_cells_mortar/disc.contact_3.csv' using (along(column('x'))):(column('pressure') > 0 ? column('pressure')/1e6 : NaN) with linespoints linetype 2 pointtype 7 pointsize 0.5 title '8 and 11 cells, mortar'
unset multiplot
