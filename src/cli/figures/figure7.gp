# Figure 7: X_A against its straight line in cos^2 (3.2.4). Run in this folder: gnuplot figure7.gp
load 'style.gp'
set output 'figure7.png'
data = 'figure7.csv'

# Columns: exact, line, error of n = 1.25, then of 1.56, then of 1.83.
array index[3] = ['1.25', '1.56', '1.83']
array tint[3] = [accent, morpho, faint]
array above[3] = [-0.2, -0.22, 0.55]
array weight[3] = [2, 4, 2]

set multiplot
set lmargin at screen 0.095
set rmargin at screen 0.885
set xrange [0:90]
set xtics 15
set format x ''

set tmargin at screen 0.965
set bmargin at screen 0.47
set yrange [0.58:1.01]
set ytics 0.1
set format y '%.1f'
set ylabel 'X_A(θ) / X_A(0)' textcolor rgb ink offset 0.5, 0
end(n) = sqrt(1 - 1 / (n * n))
do for [i = 1:3] {
    set label i 'n = ' . index[i] at 91, end(real(index[i])) textcolor rgb tint[i]
}
set label 10 'X_A = √(n² − sin²θ)' at 4, 0.68 textcolor rgb ink
set label 11 'dashed: straight line in cos²θ (3.2.4)' at 4, 0.63 textcolor rgb ink
plot for [i = 1:3] data using 1:(column(3 * i - 1)) with lines linecolor rgb tint[i] linewidth weight[i], \
     for [i = 1:3] data using 1:(column(3 * i)) with lines linecolor rgb ink linewidth 1.5 dashtype 2

unset label
set tmargin at screen 0.42
set bmargin at screen 0.115
set format x '%g°'
set xlabel 'angle θ' textcolor rgb ink
set yrange [-2.9:0.6]
set ytics 1
set format y '%g'
set ylabel 'error of the line (%)' textcolor rgb ink offset -1, 0
do for [i = 1:3] {
    stats data using 1:(100 * column(3 * i + 1)) nooutput
    set label i sprintf('n = %s: %.2f %% low', index[i], -STATS_min_y) at STATS_pos_min_y, STATS_min_y + above[i] center \
        textcolor rgb tint[i] font note
}
plot for [i = 1:3] data using 1:(100 * column(3 * i + 1)) with lines linecolor rgb tint[i] linewidth weight[i]
unset multiplot
