# gnuplot -e "in='sweep.csv'; rao='rao.csv'; out='sweep.png'; name='150 deg'" plot_sweep.gp
# Motions in regular waves: Bullet (points) on the frequency domain (lines), amplitude and phase.
set datafile separator ','
set terminal pngcairo size 1500,900 font 'sans,10'
set output out
# Below an encounter frequency of 0.1 rad/s the theory has no surge, sway and yaw: left out.
of(file, mode) = sprintf("< awk -F, '$3 == %d && ($2 >= 0.1 || $2 <= -0.1)' '%s'", mode, file)
modes = "surge sway heave roll pitch yaw"
set multiplot layout 4,3 \
    title 'Regular waves, heading '.name.': Bullet (points) and frequency domain (lines)'
set grid lc rgb '#dddddd'
set key top right samplen 1.5
set xlabel 'wave frequency [rad/s]'
do for [half=0:1] {
  do for [kind=0:1] {
    do for [i=1:3] {
      j = 3*half + i
      angle = j > 3
      set title word(modes, j)
      scale = angle ? 180/pi : 1
      if (kind == 0) {
        set ylabel (angle ? 'amplitude [deg/m]' : 'amplitude [m/m]')
        set yrange [0:*]
        plot of(rao, j) using 1:($4*scale) with lines lw 1.5 lc rgb '#1f77b4' \
                 title 'frequency domain', \
             of(in, j) using 1:($4*scale) with points pt 7 ps 0.8 lc rgb '#d62728' title 'Bullet'
      } else {
        set ylabel 'phase [deg]'
        set yrange [-180:180]
        set ytics 90
        plot of(rao, j) using 1:5 with points pt 7 ps 0.2 lc rgb '#1f77b4' notitle, \
             of(in, j) using 1:5 with points pt 7 ps 0.8 lc rgb '#d62728' notitle
        set ytics auto
      }
    }
  }
}
unset multiplot
