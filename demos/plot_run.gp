# gnuplot -e "in='run.csv'; out='run.png'" plot_run.gp
# Time series of one simulation: the wave at the centre of gravity, heave, roll, pitch.
set datafile separator ','
set terminal pngcairo size 1400,900 font 'sans,10'
set output out
set multiplot layout 4,1 title 'Frigate in an irregular sea, 150 deg (bow quartering)'
set grid lc rgb '#dddddd'
unset key
set xlabel 'time [s]'
set ylabel 'wave at G [m]'
plot in every ::1 using 1:14 with lines lc rgb '#1f77b4'
set ylabel 'G above calm water [m]'
plot in every ::1 using 1:4 with lines lc rgb '#2ca02c'
set ylabel 'roll [deg]'
plot in every ::1 using 1:5 with lines lc rgb '#d62728'
set ylabel 'pitch [deg]'
plot in every ::1 using 1:6 with lines lc rgb '#9467bd'
unset multiplot
