# gnuplot -e "in='turning.csv'; out='turn.png'" plot_turn.gp
# The full turn of `turning` (run 1): the track with the ship's heading every 20 s, heave beside the
# wave at the ship, roll, speed.
set datafile separator ','
set terminal pngcairo size 1500,1000 font 'sans,10'
set output out
set multiplot title 'Frigate at 8 m/s, a full turn at 1 deg/s in a sea of Hs 3 m, Tp 9 s'
set grid lc rgb '#dddddd'
turn(value) = (column(1) == 1 && column(2) <= 500) ? value : NaN
# Rows are 0.2 s apart.
each(value) = int(column(0)) % 100 == 0 ? turn(value) : NaN
set xrange [0:500]
set xlabel 'time [s]'
set size 0.62,0.31
set origin 0.38,0.64
set ylabel '[m]'
set key top center horizontal
plot in every ::1 using (turn($2)):12 with lines lc rgb '#1f77b4' title 'wave at G', \
     in every ::1 using (turn($2)):11 with lines lw 2 lc rgb '#2ca02c' title 'heave of G'
unset key
set origin 0.38,0.33
set ylabel 'roll [deg]'
plot in every ::1 using (turn($2)):6 with lines lc rgb '#d62728'
set origin 0.38,0.02
set ylabel 'speed [m/s]'
plot in every ::1 using (turn($2)):7 with lines lc rgb '#9467bd'
set size 0.38,0.95
set origin 0.0,0.02
set autoscale
set size ratio -1
set xlabel 'x [m]; the waves come from the right'
set ylabel 'y [m]'
L = 60
plot in every ::1 using (turn($3)):4 with lines lc rgb '#1f77b4', \
     in every ::1 using (each($3)):4:(L*cos($5*pi/180)):(L*sin($5*pi/180)) \
     with vectors filled lc rgb '#d62728'
unset multiplot
