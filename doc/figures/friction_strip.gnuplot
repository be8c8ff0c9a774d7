# Pull against the movement of the end of a strip on a frictional bed, beside the exact
# solution of a bar.

name   = 'friction_strip'
height = 480
width  = 850
load 'style.gnuplot'

# F(t) up to F0, back, to -F0, and to F0 again; tau E A in N^2/m
F0       = 600.
tauEA    = 3000.*200e9*1e-5
pull(t)  = F0*(t < 1 ? t : t < 3 ? 2 - t : t - 4)
top      = F0**2/(2*tauEA)
exact(t) = 1e6*(t < 1 ? pull(t)**2/(2*tauEA) : \
                t < 3 ? top - (F0 - pull(t))**2/(4*tauEA) : (F0 + pull(t))**2/(4*tauEA) - top)

set title 'An elastic strip on a frictional bed' font ',13'
set parametric
set trange [0:5]
set samples 501
set lmargin 9
set rmargin 3
set key at graph 0.02, graph 0.97 left top Left reverse
set xlabel 'movement of the end [{/Symbol m}m]' offset 0, 0.4
set ylabel 'pull [N]'
set xrange [-35:35]
set yrange [-700:700]
plot \
  exact(t), pull(t) with lines linecolor rgb '#d55e00' linewidth 5 title 'exact, of a bar', \
  history('friction_strip') using (1e6*column("end.displacement_x [m]")):(pull($1)) \
    with linespoints linetype 1 pointtype 7 pointsize 0.5 title 'computed'
