# cutwater righting meshes/frigate/ship.toml --heel 0:180:181 -o frigate.csv, meshes/boat likewise
# gnuplot -e "frigate='frigate.csv'; boat='boat.csv'; out='righting.png'" plot_righting.gp
# Levers with free trim, over the greatest of each, and the trim that comes with them.
set datafile separator ','
set terminal pngcairo size 1200,800 font 'sans,10'
set output out
set multiplot layout 2,1 title 'Righting levers in calm water, trim free'
set grid lc rgb '#dddddd'
set xzeroaxis lc rgb 'black'
set xrange [0:180]
set xtics 15
set xlabel 'heel [deg]'
set ylabel 'GZ / greatest GZ'
set key bottom left
stats frigate every ::1 using 2 name 'F' nooutput
stats boat every ::1 using 2 name 'B' nooutput
plot frigate every ::1 using 1:($2/F_max) with lines lw 2 \
         title sprintf('frigate, greatest %.2f m: turns over where GZ vanishes', F_max), \
     boat every ::1 using 1:($2/B_max) with lines lw 2 \
         title sprintf('boat, greatest %.2f m: its wheelhouse rights it from any heel', B_max)
set ylabel 'trim [deg], bow down'
unset key
plot frigate every ::1 using 1:4 with lines lw 2, boat every ::1 using 1:4 with lines lw 2
unset multiplot
