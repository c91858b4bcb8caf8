# Figure 14: derived reflectance spectra, each in its own colour. Run in this folder: gnuplot figure14.gp
load 'style.gp'
set output 'figure14.png'
array specimen[2] = ['morpho', 'beetle']
array title[2] = ['Morpho butterfly', 'Jewel beetle']
# Curve k of specimen i has its lobe and its colour at 8 i + k.
array display_rgb[24]
array peak[24]
array width[24]
array curves[2]
array top[2] = [0.965, 0.51]

do for [i = 1:2] {
    stats sprintf('figure14_%s_colours.csv', specimen[i]) \
        using (k = 8 * i + int(column(0)) + 1, peak[k] = column('peak_nm'), width[k] = column('width_nm'), \
               display_rgb[k] = column('display_rgb')) nooutput
    curves[i] = STATS_records
}

# Curves end where they reach 0; the half nanometre beyond brings the line there.
inside(nm, k) = abs(nm - peak[k]) < 0.5 * width[k] + 0.5
# Peaks near the normal crowd.
aside(angle) = angle == 0 ? 3 : angle == 10 ? -3 : 0

set multiplot
set lmargin at screen 0.095
set rmargin at screen 0.965
set xrange [360:620]
set yrange [0:1.12]
set xtics 20
set ytics 0, 0.2, 1
set format y '%.1f'
set ylabel 'reflectance' textcolor rgb ink offset 0.5, 0
do for [i = 1:2] {
    data = sprintf('figure14_%s.csv', specimen[i])
    colours = sprintf('figure14_%s_colours.csv', specimen[i])
    set tmargin at screen top[i]
    set bmargin at screen top[i] - 0.39
    set format x (i == 2 ? '%g' : '')
    if (i == 2) { set xlabel 'wavelength λ (nm)' textcolor rgb ink }
    set label 1 title[i] at 617, 1.0 right textcolor rgb ink font heading
    if (i == 2) { unset label 2 } else { set label 2 'each curve in the colour it has under D65' at 617, 0.88 right textcolor rgb faint font note }
    plot for [k = 1:curves[i]] data using 1:(inside(column(1), 8 * i + k) ? column(k + 1) : NaN) with lines linecolor rgb display_rgb[8 * i + k] linewidth 3.5, \
         colours using (column('peak_nm') + aside(column('angle_deg'))):(column('height') + 0.05):(sprintf('%g°', column('angle_deg'))):'display_rgb' \
             with labels textcolor rgb variable
}
unset multiplot
