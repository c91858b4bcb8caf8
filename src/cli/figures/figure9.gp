# Figure 9: the lobe's three numbers against the angle. Run in this folder: gnuplot figure9.gp
load 'style.gp'
set output 'figure9.png'
array lobe[2] = ['figure9_morpho.csv', 'figure9_beetle.csv']
array picks[2] = ['picks_morpho.csv', 'picks_beetle.csv']
array title[2] = ['Morpho', 'Jewel beetle']
array tint[2] = [morpho, beetle]
array from[2]
array to[2]
array end[2]
do for [i = 1:2] {
    stats picks[i] using 'angle_deg' nooutput
    from[i] = STATS_min
    to[i] = STATS_max
}
array column_name[3] = ['peak_nm', 'width_nm', 'height']
array raw_name[3] = ['peak_nm', 'unclamped_width_nm', 'unclamped_height']
array axis_title[3] = ['λ_{peak} (nm)', 'w (nm)', 'h']
array low[3] = [180, 20, -0.25]
array high[3] = [570, 130, 1.4]
array step[3] = [100, 50, 0.5]
array top[3] = [0.97, 0.685, 0.4]

between(i) = (column('angle_deg') >= from[i] && column('angle_deg') <= to[i])

set multiplot
set lmargin at screen 0.095
set rmargin at screen 0.87
set xrange [0:90]
set xtics 15
do for [panel = 1:3] {
    set tmargin at screen top[panel]
    set bmargin at screen top[panel] - 0.265
    set format x (panel == 3 ? '%g°' : '')
    if (panel == 3) { set xlabel 'angle θ' textcolor rgb ink }
    set yrange [low[panel] : high[panel]]
    set ytics step[panel]
    set ylabel axis_title[panel] textcolor rgb ink offset 0.5, 0
    do for [i = 1:2] {
        stats lobe[i] using (end[i] = column(column_name[panel])) nooutput
        set label i title[i] at 91, end[i] textcolor rgb tint[i]
    }
    if (panel == 3) {
        set label 11 'asks for more than 1: clamped' at 89, 1.24 right textcolor rgb beetle font note
        set label 12 'asks for less than 0: clamped' at 84, -0.13 right textcolor rgb morpho font note
        set label 13 'thick: between the picks' at 1, 0.1 textcolor rgb ink font note
    }
    plot for [i = 1:2] lobe[i] using 'angle_deg':(column(raw_name[panel])) with lines linecolor rgb tint[i] linewidth 1.5 dashtype 3, \
         for [i = 1:2] lobe[i] using 'angle_deg':(column(column_name[panel])) with lines linecolor rgb tint[i] linewidth 2, \
         for [i = 1:2] lobe[i] using 'angle_deg':(between(i) ? column(column_name[panel]) : NaN) with lines linecolor rgb tint[i] linewidth 4, \
         for [i = 1:2] picks[i] using 'angle_deg':(column(column_name[panel])) with points pointtype 5 pointsize 3 linecolor rgb tint[i]
    unset label
}
unset multiplot
