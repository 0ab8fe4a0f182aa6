# gnuplot -e "name='capsize'; in='capsize.csv'; out='pictures/capsize.png'" plot_demo.gp
# One small picture of a demo's CSV, for README.md.
set datafile separator ','
set datafile missing 'nan'
set terminal pngcairo size 460,300 font 'sans,8'
set output out
set grid lc rgb '#dddddd'
set border 3
set tics nomirror
set key top right samplen 2
blue = 0x0b5c92; red = 0xc44e12; green = 0x11785a; grey = 0x888888
# The value where a column has this number, else nothing.
only(c, number, value) = (abs(column(c) - number) < 1e-6) ? value : NaN
set xlabel 't [s]'
if (name eq 'adrift') {
  set ylabel 'speed [m/s], turning [°/s]'
  plot in every ::1 using 2:(only(1, 0, $4)) \
         with lines lc rgb blue title 'pushed from abeam: leeway', \
       in every ::1 using 2:(only(1, 1, $5)) with lines lc rgb red title 'spun: turning', \
       in every ::1 using 2:(only(1, 2, $3)) with lines lc rgb green title 'with way on: speed'
}
if (name eq 'beam_roll') {
  set ylabel 'roll [°]'
  stats in every ::1 using 1 nooutput
  high = STATS_max
  plot in every ::1 using 3:(only(1, high, only(2, 0, $4))) \
         with lines lc rgb grey title 'linear', \
       in every ::1 using 3:(only(1, high, only(2, 1, $4))) \
         with lines lc rgb blue title 'nonlinear'
}
if (name eq 'capsize') {
  set ylabel 'roll [°]'
  stats in every ::1 using 1 nooutput
  low = STATS_min
  high = STATS_max
  set xrange [0:120]
  plot in every ::1 using 2:(only(1, low, $3)) with lines lc rgb blue \
         title sprintf('let go at %.0f°', low), \
       in every ::1 using 2:(only(1, high, $3)) with lines lc rgb red \
         title sprintf('at %.0f°', high)
}
if (name eq 'cargo') {
  set ylabel '[°], [m]'
  plot in every ::1 using 1:2 with lines lc rgb blue title 'roll', \
       in every ::1 using 1:4 with lines lc rgb red title 'one box slides [m]', \
       in every ::1 using 1:5 with lines lc rgb green title 'the other [m]'
}
if (name eq 'collision') {
  set ylabel 'speed [m/s]'
  stats in every ::1 using 2 nooutput
  most = STATS_max
  plot in every ::1 using 3:(only(1, 0, only(2, most, $4))) \
         with lines lc rgb blue title 'ramming ship', \
       in every ::1 using 3:(only(1, 0, only(2, most, $5))) \
         with lines lc rgb red title 'ship that is rammed'
}
if (name eq 'crane') {
  set ylabel '[°]'
  plot in every ::1 using 1:2 with lines lc rgb blue title 'roll', \
       in every ::1 using 1:3 with lines lc rgb red title 'swing of the load'
}
if (name eq 'drop') {
  set xlabel 'time since the hull met the water [s]'
  set ylabel 'felt [g]'
  set xrange [-0.5:3]
  plot in every ::1 using (only(1, 0, $3)):7 with lines lc rgb blue title 'level, from 3 m', \
       in every ::1 using (only(1, 1, $3)):8 with lines lc rgb red title 'bow first, at the bow'
}
if (name eq 'fleet') {
  set ylabel 'heave [m]'
  plot in every ::1 using 2:(only(1, 0, $5)) with points pt 7 ps 0.25 lc rgb blue title 'ship 0', \
       in every ::1 using 2:(only(1, 8, $5)) with points pt 7 ps 0.25 lc rgb red title 'ship 8', \
       in every ::1 using 2:(only(1, 500, $5)) with points pt 7 ps 0.25 lc rgb green \
         title 'ship 500'
}
if (name eq 'following_seas') {
  set ylabel '[m], [°]'
  stats in every ::1 using 1 nooutput
  set xrange [STATS_max - 60:STATS_max]
  plot in every ::1 using 1:2 with lines lc rgb grey title 'wave at the bow', \
       in every ::1 using 1:4 with lines lc rgb blue title 'heave', \
       in every ::1 using 1:5 with lines lc rgb red title 'roll [°]'
}
if (name eq 'flooding') {
  set ylabel '[m], [°]'
  set yrange [-130:30]
  plot in every ::1 using 1:2 with lines lc rgb blue title 'height of G [m]', \
       in every ::1 using 1:3 with lines lc rgb red title 'roll [°]'
}
if (name eq 'lock') {
  set ylabel '[m]'
  plot in every ::1 using 1:2 with lines lc rgb blue title 'calm water', \
       in every ::1 using 1:3 with lines lc rgb red title 'height of G'
}
if (name eq 'overboard') {
  set ylabel '[°], [m]'
  plot in every ::1 using 1:2 with lines lc rgb blue title 'roll [°]', \
       in every ::1 using 1:6 with lines lc rgb red title 'height of a crate [m]', \
       in every ::1 using 1:3 with lines lc rgb green title 'crates overboard'
}
if (name eq 'manoeuvres') {
  set xlabel 'x [m]'
  set ylabel 'y [m]'
  set size ratio -1
  plot in every ::1 using (only(1, 0, $3)):4 with lines lc rgb blue title 'full rudder', \
       in every ::1 using (only(1, 1, $3)):4 with lines lc rgb red title 'full astern', \
       in every ::1 using (only(1, 2, $3)):4 with lines lc rgb green title 'zigzag'
}
if (name eq 'quay') {
  set ylabel 'speed abeam [m/s]'
  plot in every ::1 using 1:3 with lines lc rgb blue notitle
}
if (name eq 'steep_head_seas') {
  set xlabel 'λ/L'
  set ylabel 'heave/a'
  plot in every ::1 using (only(1, 0.2, only(2, 0, $4))):10 \
         with points pt 7 ps 0.4 lc rgb grey title 'frequency domain', \
       in every ::1 using (only(1, 0.2, only(2, 0, $4))):($5 < 0.01 ? $6 : NaN) \
         with points pt 6 lc rgb blue title 'nonlinear, H/λ 1/300', \
       in every ::1 using (only(1, 0.2, only(2, 0, $4))):($5 > 0.06 ? $6 : NaN) \
         with points pt 6 lc rgb red title '1/15'
}
if (name eq 'storm_builds') {
  set ylabel 'wave at G [m], roll [°]'
  plot in every ::1 using 1:5 with lines lc rgb red title 'roll', \
       in every ::1 using 1:14 with lines lc rgb blue title 'wave'
}
if (name eq 'tow') {
  set ylabel 'speed of the ship [m/s]'
  stats in every ::1 using 1 nooutput
  most = STATS_max
  plot in every ::1 using 2:(only(1, most, $4)) with lines lc rgb blue notitle
}
if (name eq 'turning') {
  set xlabel 'x [m]'
  set ylabel 'y [m]'
  set size ratio -1
  plot in every ::1 using (only(1, 1, $3)):4 \
         with lines lc rgb blue title 'round once, in a sea of 3 m'
}
if (name eq 'wind') {
  set ylabel 'roll [°]'
  plot in every ::1 using 1:2 with lines lc rgb blue notitle
}
if (name eq 'free_decay') {
  set ylabel 'height of G [m]'
  plot in every ::1 using 1:4 with lines lc rgb blue notitle
}
if (name eq 'head_seas' || name eq 'irregular_sea' || name eq 'hello_ship') {
  set ylabel '[m], [°]'
  stats in every ::1 using 1 nooutput
  set xrange [STATS_max - 60:STATS_max]
  wave = (name eq 'hello_ship') ? 8 : 14
  plot in every ::1 using 1:(column(wave)) with lines lc rgb grey title 'wave at G', \
       in every ::1 using 1:4 with lines lc rgb blue title 'height of G', \
       in every ::1 using 1:6 with lines lc rgb red title 'pitch [°]'
}
