# Contact force and energy of the beam against time, for three time integrations.

name   = 'schemes'
height = 760
load 'style.gnuplot'

force = 'column("floor.force_y [N]")/1e3'
above = '(column("energy.kinetic [J]") + column("energy.stored [J]") + column("energy.damping [J]") - column("work.loads [J]"))'
lost  = 'column("energy.scheme_loss [J]")'
set multiplot layout 4, 1 title 'Cantilever beam striking a rigid floor: three time integrations' font ',17'

set lmargin 10
set rmargin 3
set xrange [0.55:0.95]
set yrange [0:*]
set ylabel 'force [kN]'
set key top right
plot history('cantilever_beam') using (1e3*$1):(@force) with lines linetype 1 title 'Signorini, default'
plot history('trapezoidal') using (1e3*$1):(@force) with lines linetype 2 title 'trapezoidal rule, consistent mass'
set xlabel 'time [ms]' offset 0, 0.4
plot history('paper_time_integration') using (1e3*$1):(@force) with lines linetype 3 title 'Meguid & Czekanski, consistent mass'

set xrange [0:12]
set yrange [0:110]
set ylabel 'energy kept [%]'
set key bottom left
plot \
  history('cantilever_beam') using (1e3*$1):(100*(1 + @above/energy)) with lines linetype 1 title 'default', \
  history('trapezoidal') using (1e3*$1):(100*(1 + @above/energy)) with lines linetype 2 title 'trapezoidal rule', \
  history('paper_time_integration') using (1e3*$1):(100*(1 + @above/energy)) with lines linetype 3 title 'Meguid & Czekanski'
unset multiplot
