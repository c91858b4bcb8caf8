# The bands of a palette: what floor and flatness do. Run in this folder: gnuplot bands.gp
load 'style.gp'
set output 'bands.png'
data = 'bands.csv'
array title[4] = ['half cosine, as in the paper', 'flatness %g: a plateau', 'floor %g: light at every wavelength', 'notch: the floor is above the height']
array left[4] = [0.08, 0.57, 0.08, 0.57]
array top[4] = [0.925, 0.925, 0.485, 0.485]
array peak[4]
array width[4]
array height[4]
array floor_of[4]
array flatness[4]
stats 'bands_lobes.csv' using (k = int(column(0)) + 1, peak[k] = column('peak_nm'), width[k] = column('width_nm'), \
    height[k] = column('height'), floor_of[k] = column('floor'), flatness[k] = column('flatness')) nooutput
title[2] = sprintf(title[2], flatness[2])
title[3] = sprintf(title[3], floor_of[3])

set multiplot
set xrange [380:780]
set xtics 400, 50
set yrange [-0.2:1.06]
set ytics 0, 0.2, 1
set format y '%.1f'
do for [i = 1:4] {
    set lmargin at screen left[i]
    set rmargin at screen left[i] + 0.4
    set tmargin at screen top[i]
    set bmargin at screen top[i] - 0.375
    set format x (i > 2 ? '%g' : '')
    set xlabel (i > 2 ? 'wavelength λ (nm)' : '') textcolor rgb ink
    set ylabel (i % 2 == 1 ? 'reflectance' : '') textcolor rgb ink offset 0.5, 0
    set label 1 title[i] at graph 0, 1.07 textcolor rgb ink font heading
    set label 2 sprintf('floor = %g', floor_of[i]) at 772, floor_of[i] + 0.06 right textcolor rgb accent font note
    if (i > 2) { set label 4 'dashed: the half cosine' at 772, -0.08 right textcolor rgb faint font note }
    if (i != 2) {
        set label 3 sprintf('height = %g', height[i]) at peak[i], height[i] + (i == 4 ? -0.08 : 0.07) center textcolor rgb accent font note
    } else {
        plateau = flatness[i] * width[i]
        set arrow 1 from peak[i], floor_of[i] to peak[i], height[i] heads filled size screen 0.008, 20 linecolor rgb accent linewidth 1.5
        set label 3 sprintf("height\n= %g", height[i]) at peak[i] + 6, 0.46 textcolor rgb accent font note
        set label 4 sprintf("peak\n= %g nm", peak[i]) at peak[i] + 6, 0.16 textcolor rgb accent font note
        set arrow 2 from peak[i] - 0.5 * plateau, height[i] + 0.06 to peak[i] + 0.5 * plateau, height[i] + 0.06 heads filled size screen 0.008, 20 linecolor rgb accent linewidth 1.5
        set label 5 sprintf('plateau = flatness × width = %g nm', plateau) at peak[i], height[i] + 0.14 center textcolor rgb accent font note
        set arrow 3 from peak[i] - 0.5 * width[i], -0.06 to peak[i] + 0.5 * width[i], -0.06 heads filled size screen 0.008, 20 linecolor rgb accent linewidth 1.5
        set label 6 sprintf('width = %g nm', width[i]) at peak[i], -0.13 center textcolor rgb accent font note
    }
    plot data using 1:2 with lines linecolor rgb faint linewidth 2 dashtype 2, \
         data using 1:(column(i + 1)) with lines linecolor rgb morpho linewidth 4
    unset label
    unset arrow
}
unset multiplot
