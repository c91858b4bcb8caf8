# Figure 5: the reflectance lobe of one pick. Run in this folder: gnuplot figure5.gp
load 'style.gp'
set output 'figure5.png'
data = 'figure5.csv'

stats data using 1:2 nooutput
peak = STATS_pos_max_y
height = STATS_max_y
width = 0.5 * (STATS_max_x - STATS_min_x)
left_end = peak - 0.5 * width
right_end = peak + 0.5 * width

set lmargin at screen 0.085
set rmargin at screen 0.965
set tmargin at screen 0.955
set bmargin at screen 0.115
set xrange [peak - 0.86 * width : peak + 0.86 * width]
set yrange [-0.13 : 1.16]
set xtics 10
set ytics 0, 0.2, 1
set xlabel 'wavelength λ (nm)' textcolor rgb ink
set ylabel 'reflectance' textcolor rgb ink offset 0.5, 0

# The three numbers.
set arrow 1 from peak, 0 to peak, height heads filled size screen 0.008, 20 linecolor rgb accent linewidth 1.5
set label 1 sprintf('h = %g', height) at peak + 1.5, 0.42 textcolor rgb accent
set arrow 2 from left_end, -0.06 to right_end, -0.06 heads filled size screen 0.008, 20 linecolor rgb accent linewidth 1.5
set label 2 sprintf('w = %g nm, from zero to zero', width) at peak, -0.1 center textcolor rgb accent
set label 3 sprintf('λ_{peak} = %g nm', peak) at peak, height + 0.07 center textcolor rgb accent
# What the name "width" usually means.
set arrow 4 from peak - width / 3, height / 2 to peak + width / 3, height / 2 nohead dashtype 2 linecolor rgb faint linewidth 1.5
set label 4 sprintf('%.1f nm at half height', width * 2 / 3) at peak + width / 3 + 2, height / 2 textcolor rgb faint
set label 5 'R(λ) = h cos(π(λ − λ_{peak}) / w)' at left_end - 23, 0.9 textcolor rgb morpho
set label 6 'dots: every 5 nm' at left_end - 23, 0.82 textcolor rgb faint font note

plot data using 1:2 with lines linestyle 1, \
     data using 1:2 every 10 with points pointtype 7 pointsize 2 linecolor rgb morpho
