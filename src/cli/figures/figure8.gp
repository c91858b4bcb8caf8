# Figure 8: peak wavelength against angle: Bragg's law, (3.2.5), an exact stack. Run in this folder: gnuplot figure8.gp
load 'style.gp'
set output 'figure8.png'
array specimen[2] = ['morpho', 'beetle']
array title[2] = ['Morpho: n = 1.56, 94.1 nm; air, 83.2 nm', 'Jewel beetle: solid stack, n = 1.717']
array shape[2] = ['0.26', '0.91']
array tint[2] = [morpho, beetle]
array bottom[2] = [195, 420]
array top[2] = [480, 545]
array left[2] = [0.08, 0.58]

# Where the names of the curves stand: angle and height.
array bragg_x[2] = [45, 35]
array bragg_y[2] = [405, 511]
array cos2_x[2] = [88, 88]
array cos2_y[2] = [340, 457]
array palette_x[2] = [4, 4]
array palette_y[2] = [220, 427]
array error_x[2] = [89.5, 57]
array error_y[2] = [4.25, -2.6]
array fitted_x[2] = [50, 2]
array fitted_y[2] = [-1.7, 1.6]
array cos2_error_x[2] = [46, 86]
array cos2_error_y[2] = [-3.7, 3.6]
array exact_x[2] = [88, 62]
array exact_y[2] = [430, 525]
# Against the exact peak: the Morpho's stack is not weak, the beetle's is.
array exact_range[2] = [26, 5]
array exact_step[2] = [10, 2]
array verdict_y[2] = [20, 3.6]

array palette_worst[2]
array fitted_worst[2]
array cos2_worst[2]
array bragg_worst[2]
do for [i = 1:2] {
    data = sprintf('figure8_%s.csv', specimen[i])
    stats data using (abs(column('palette_error_nm'))) nooutput
    palette_worst[i] = STATS_max
    stats data using (abs(column('fitted_error_nm'))) nooutput
    fitted_worst[i] = STATS_max
    stats data using (abs(column('cos2_error_nm'))) nooutput
    cos2_worst[i] = STATS_max
    stats sprintf('picks_%s.csv', specimen[i]) using 'angle_deg' nooutput
    first = STATS_min
    last = STATS_max
    stats data using (column('angle_deg') >= first && column('angle_deg') <= last ? abs(column('bragg_exact_error_nm')) : NaN) nooutput
    bragg_worst[i] = STATS_max
}

set multiplot
set xrange [0:90]
set xtics 15
do for [i = 1:2] {
    data = sprintf('figure8_%s.csv', specimen[i])
    picks = sprintf('picks_%s.csv', specimen[i])
    set lmargin at screen left[i]
    set rmargin at screen left[i] + 0.39

    set tmargin at screen 0.925
    set bmargin at screen 0.575
    set format x ''
    unset xlabel
    set yrange [bottom[i] : top[i]]
    set ytics autofreq
    set ylabel 'peak (nm)' textcolor rgb ink offset 0.8, 0
    set label 1 title[i] at screen left[i], 0.965 textcolor rgb tint[i]
    set label 2 "Bragg's law" at bragg_x[i], bragg_y[i] textcolor rgb tint[i] font note
    set label 3 'cos²θ (3.2.4)' at cos2_x[i], cos2_y[i] right textcolor rgb faint font note
    set label 4 'dashed: (3.2.5), p = ' . shape[i] . ', through the picks' at palette_x[i], palette_y[i] textcolor rgb ink font note
    set label 5 'exact stack' at exact_x[i], exact_y[i] right textcolor rgb accent font note
    plot data using 'angle_deg':'cos2_nm' with lines linecolor rgb faint linewidth 2 dashtype 3, \
         data using 'angle_deg':'bragg_nm' with lines linecolor rgb tint[i] linewidth 4, \
         data using 'angle_deg':'exact_nm' with lines linecolor rgb accent linewidth 2.5, \
         data using 'angle_deg':'palette_nm' with lines linecolor rgb ink linewidth 1.5 dashtype 2, \
         picks using 'angle_deg':'peak_nm' with points pointtype 5 pointsize 3 linecolor rgb ink
    unset label

    set tmargin at screen 0.535
    set bmargin at screen 0.335
    set yrange [-5:5]
    set ytics 2
    set ylabel 'vs Bragg (nm)' textcolor rgb ink offset -0.6, 0
    set label 2 sprintf('through picks: %.1f nm', palette_worst[i]) at error_x[i], error_y[i] right textcolor rgb ink font note
    set label 3 sprintf('fitted: %.1f nm', fitted_worst[i]) at fitted_x[i], fitted_y[i] textcolor rgb tint[i] font note
    set label 4 sprintf('(3.2.4): %.1f nm', cos2_worst[i]) at cos2_error_x[i], cos2_error_y[i] right textcolor rgb faint font note
    plot data using 'angle_deg':'cos2_error_nm' with lines linecolor rgb faint linewidth 2 dashtype 3, \
         data using 'angle_deg':'fitted_error_nm' with lines linecolor rgb tint[i] linewidth 3, \
         data using 'angle_deg':'palette_error_nm' with lines linecolor rgb ink linewidth 2 dashtype 2, \
         picks using 'angle_deg':(0) with points pointtype 5 pointsize 2.4 linecolor rgb ink
    unset label

    set tmargin at screen 0.295
    set bmargin at screen 0.095
    set format x '%g°'
    set xlabel 'angle θ' textcolor rgb ink
    set yrange [-exact_range[i] : exact_range[i]]
    set ytics exact_step[i]
    set ylabel 'vs exact (nm)' textcolor rgb ink offset -0.6, 0
    set label 2 sprintf("Bragg's law: %.2f nm between the picks", bragg_worst[i]) at 88, verdict_y[i] right textcolor rgb tint[i] font note
    plot data using 'angle_deg':'cos2_exact_error_nm' with lines linecolor rgb faint linewidth 2 dashtype 3, \
         data using 'angle_deg':'bragg_exact_error_nm' with lines linecolor rgb tint[i] linewidth 4, \
         data using 'angle_deg':'palette_exact_error_nm' with lines linecolor rgb ink linewidth 2 dashtype 2
    unset label
}
unset multiplot
