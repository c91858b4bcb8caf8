# Moves of an automatic user to a given picture. Run in this folder: gnuplot study.gp
load 'style.gp'
set output 'study.png'
data = 'study_curves.csv'
array half[2] = ['picks', 'layers']
array title[2] = ['Targets made by picks', 'Targets made by physical parameters']
array way[2] = ['picks', 'layers']
array tint[2] = [morpho, accent]
array name[2] = ['two picks', 'physical parameters']

set multiplot
set xrange [0:400]
set xtics 100
do for [i = 1:2] {
    set lmargin at screen (i == 1 ? 0.095 : 0.56)
    set rmargin at screen (i == 1 ? 0.5 : 0.965)
    set tmargin at screen 0.92
    set bmargin at screen 0.54
    set format x ''
    unset xlabel
    set yrange [0:1]
    set ytics 0, 0.25, 1
    set format y (i == 1 ? '%.2f' : '')
    set ylabel (i == 1 ? 'share of targets reached' : '') textcolor rgb ink offset 0.5, 0
    set label 1 title[i] at 0, 1.07 textcolor rgb ink font heading
    do for [k = 1:2] { set label 1 + k name[k] at 12, 1.02 - 0.08 * k textcolor rgb tint[k] }
    plot for [k = 1:2] data using 1:(column(way[k] . '_to_' . half[i] . '_share')) with steps linecolor rgb tint[k] linewidth 4
    unset label

    set tmargin at screen 0.49
    set bmargin at screen 0.115
    set format x '%g'
    set xlabel 'moves' textcolor rgb ink
    set yrange [0:55]
    set ytics 0, 10, 50
    set format y (i == 1 ? '%g' : '')
    set ylabel (i == 1 ? 'median ΔE_{00} of the best picture' : '') textcolor rgb ink offset 0.5, 0
    set label 1 'reached: 2' at 395, 4.5 right textcolor rgb faint font note
    plot 2 with lines linecolor rgb faint linewidth 1.5 dashtype 2, \
         for [k = 1:2] data using 1:(column(way[k] . '_to_' . half[i] . '_de00')) with lines linecolor rgb tint[k] linewidth 4
    unset label
}
unset multiplot
