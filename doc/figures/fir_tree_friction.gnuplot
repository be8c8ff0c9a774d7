# Fir-tree joint and friction: the largest shear stress in the disc along the lowest flank (figure
# 23b of Meguid & Czekanski), slip times shear there, and stresses against the coefficient.

name   = 'fir_tree_friction'
height = 400
width  = 1200
load 'style.gnuplot'

study    = folder . '/fir_tree_studies/friction'
run(mu)  = study . '/mu_' . mu
summary  = study . '/summary.csv'
# The ends of the lowest flank, mm.
x0 = 7.692858
l  = 3*cos(25*pi/180)
along(x) = (1e3*x - x0)/l

set tics font ',10'
set key font ',10'
set xlabel font ',11'
set ylabel font ',11'
set multiplot layout 1, 3 margins 0.08, 0.985, 0.14, 0.9 spacing 0.08, 0.1
set key top center
set xlabel 'place on the flank, upper to lower end' offset 0, 0.4
set ylabel 'largest shear stress [MPa]'
set xrange [0:1]
set yrange [0:600]
set title 'In the disc, along the lowest flank' font ',13'
plot for [i = 1:3] run(word('0 0.1 0.5', i)) . '/flank_3.csv' using ($1/0.003):($3/1e6) \
  with linespoints linetype i pointtype 7 pointsize 0.5 title 'friction ' . word('0 0.1 0.5', i)

set ylabel 'slip × shear [kJ/m²]'
set yrange [0:3.5]
set title 'Slip times shear, spin-up' font ',13'
plot for [i = 1:3] run(word('0.05 0.1 0.5', i)) . '/disc.contact_3.csv' \
  using (along(column('x'))):(column('pressure') > 0 ? abs(column('slip')*column('shear'))/1e3 : NaN) \
  with linespoints linetype i pointtype 7 pointsize 0.5 title 'friction ' . word('0.05 0.1 0.5', i)

set xlabel 'coefficient of friction'
set ylabel 'stress [MPa]'
set xrange [0:0.52]
set yrange [0:1600]
set key right top at graph 0.98, 0.4
set title 'Stresses' font ',13'
plot summary using 2:(column('disc von Mises [MPa]')) with linespoints linetype 1 pointtype 7 pointsize 0.7 title 'von Mises, disc', \
  summary using 2:(column('blade notch 3 [MPa]')) with linespoints linetype 2 pointtype 7 pointsize 0.7 title 'tension, blade', \
  summary using 2:(column('mean pressure 3 [MPa]')) with linespoints linetype 3 pointtype 7 pointsize 0.7 title 'mean pressure, flank 3'
unset multiplot
