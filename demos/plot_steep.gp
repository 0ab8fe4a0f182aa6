# gnuplot -e "in='steep_head_seas.csv'; out='steep.png'" plot_steep.gp
# Figures 37 and 38: heave and pitch in head seas at Fn 0.12 and 0.20, surge held (full lines) and
# free (dashed), of growing steepness; points: linear in time, black: frequency domain.
set datafile separator ','
set terminal pngcairo size 1400,1000 font 'sans,10'
set output out
set multiplot layout 2,2 title 'Regular head seas of growing steepness H/lambda'
set grid lc rgb '#dddddd'
set xlabel 'wave frequency x sqrt(L/g)'
set yrange [0:1.4]
set key top right
steep = "300 30 20 15"
colours = "#1f77b4 #2ca02c #ff7f0e #d62728"
rows = "< awk -F, 'NR > 1 && $1 == %g && $2 == %d && sprintf(\"%%.0f\", 1/$5) == %d' '%s'"
of(froude, free, one) = sprintf(rows, froude, free, one, in)
do for [froude in "0.12 0.20"] {
  do for [pitch=0:1] {
    set title 'Fn = '.froude
    set ylabel (pitch ? 'pitch / k a' : 'heave / a')
    plot of(froude+0, 0, 300) using 3:(column(10+pitch)) with lines lw 2 lc rgb 'black' \
             title 'frequency domain', \
         of(froude+0, 0, 300) using 3:(column(8+pitch)) with points pt 6 lc rgb 'black' \
             title 'linear', \
         for [i=1:4] of(froude+0, 0, int(word(steep, i))) using 3:(column(6+pitch)) with lines \
             lw 1.5 lc rgb word(colours, i) title 'nonlinear, 1/'.word(steep, i), \
         for [i=1:4] of(froude+0, 1, int(word(steep, i))) using 3:(column(6+pitch)) with lines \
             dt 2 lc rgb word(colours, i) notitle
  }
}
unset multiplot
