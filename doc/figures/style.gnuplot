# What the figures have in common: colours, frames, output. A figure's script sets
# `name', `height' and, if a PNG is not to be 1200 wide, `width', and loads this file.
# format: svg or png; folder: where the runs are; both are given by scripts/figure.

if (format eq 'svg') {
  set terminal svg size 1000,height font 'Helvetica,15' background 'white' enhanced
} else {
  if (!exists('width')) { width = 1200 }
  set terminal pngcairo size width,width*height/1000 font sprintf('Helvetica,%g', 13.5*width/1200) background 'white' enhanced
}
set output name . '.' . format

set datafile separator ','
set border 3 linewidth 0.8 linecolor rgb '#404040'
set tics nomirror out scale 0.6
set grid linewidth 0.5 linecolor rgb '#e4e4e4'
set key samplen 2.5

# Colours that differ in lightness, too.
set linetype 1 linecolor rgb '#000000' linewidth 2
set linetype 2 linecolor rgb '#0072b2' linewidth 1.6
set linetype 3 linecolor rgb '#d55e00' linewidth 1.6
set linetype 4 linecolor rgb '#009e73' linewidth 1.6
set linetype 5 linecolor rgb '#cc79a7' linewidth 1.6

# Static deflection of beam theory, F L^3/(3 E I), in m, and the energy that the beam has
# above its static rest, F gap/2, in J.
deflection = 54.79452e-6
energy     = 0.02739726

history(run) = folder . '/' . run . '/history.csv'
