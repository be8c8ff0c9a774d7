# Contact force and energy of the beam against time, for three time integrations.

name   = 'schemes'
height = 760
load 'style.gnuplot'

force = 'column("floor.force_y [N]")/1e3'
above = '(column("energy.kinetic [J]") + column("energy.stored [J]") + column("energy.damping [J]") - column("work.loads [J]"))'
set multiplot layout 4, 1 title "Cantilever beam striking a rigid floor: contact force of the first bounce, and energy" font ',17' \
  margins 0.08, 0.97, 0.08, 0.91 spacing 0.1

set xrange [0.55:0.95]
set yrange [0:13]
set ytics 4
set ylabel 'force [kN]'
unset key
set label 1 'default of Signorini: redistributed mass, work returned' at graph 0.99, graph 1.1 right
plot history('cantilever_beam') using (1e3*$1):(@force) with lines linetype 1
set label 1 'trapezoidal rule, consistent mass, work lost' at graph 0.99, graph 1.1 right
plot history('trapezoidal') using (1e3*$1):(@force) with lines linetype 2
set xlabel 'time [ms]' offset 0, 0.4
set label 1 'Meguid and Czekanski, consistent mass, work lost' at graph 0.99, graph 1.1 right
plot history('paper_time_integration') using (1e3*$1):(@force) with lines linetype 3

unset label 1
set xrange [0:12]
set yrange [0:110]
set ytics 25
set ylabel 'energy kept [%]'
set key at graph 0.01, graph 0.06 left bottom Left reverse
plot \
  history('cantilever_beam') using (1e3*$1):(100*(1 + @above/energy)) with lines linetype 1 title 'default', \
  history('trapezoidal') using (1e3*$1):(100*(1 + @above/energy)) with lines linetype 2 title 'trapezoidal rule', \
  history('paper_time_integration') using (1e3*$1):(100*(1 + @above/energy)) with lines linetype 3 title 'Meguid and Czekanski'
unset multiplot
