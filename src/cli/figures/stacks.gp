load 'style.gp'
set output 'stacks_' . specimen . '.png'
spectra = 'stacks_' . specimen . '_spectra.csv'
angles = 'stacks_' . specimen . '.csv'
tint_of_specimen = specimen eq 'morpho' ? morpho : beetle
array tint[3] = [tint_of_specimen, accent, faint]
array weight[3] = [4, 3, 3]
count = words(stacks)
exact(i, column_name) = word(stacks, i) . '_' . column_name

set multiplot
set label 1 'The palette, as the paper picks it (black), beside exact stacks: ' . specimen_title at screen 0.055, 0.965 font heading textcolor rgb ink
do for [i = 1:count] {
    set label 1 + i titles[i] at screen 0.055 + 0.3 * (i - 1), 0.92 textcolor rgb tint[i]
}

# Spectra, one panel per angle of Figure 14.
set xrange [320:720]
set yrange [0:1.05]
set ytics 0, 0.2, 1
set xtics 400, 100, 700
set tmargin at screen 0.865
set bmargin at screen 0.56
do for [panel = 1:words(shown_deg)] {
    angle = word(shown_deg, panel)
    left = 0.07 + 0.184 * (panel - 1)
    set lmargin at screen left
    set rmargin at screen left + 0.17
    set format y (panel == 1 ? '%.1f' : '')
    set xlabel (panel == 3 ? 'wavelength λ (nm)' : '') textcolor rgb ink offset 0, 0.4
    if (panel == 1) { set ylabel 'reflectance' textcolor rgb ink offset 0.5, 0 } else { unset ylabel }
    set label 9 angle . '°' at 705, 0.98 right font heading textcolor rgb ink
    plot for [i = count:1:-1] spectra using 1:(column(word(stacks, i) . '_' . angle)) with lines linecolor rgb tint[i] linewidth weight[i], \
         spectra using 1:(column('palette_' . angle)) with lines linecolor rgb ink linewidth 2.5
    unset label
}

set xrange [0:90]
set xtics 15
set format x '%g°'
set tmargin at screen 0.375
set bmargin at screen 0.1
array from[3] = [0.07, 0.395, 0.715]
array heading_of[3] = ['peak (nm)', 'colour difference (CIEDE2000)', 'the same, palette picked anew']
array remark[3] = ['as far as the stack has a band', "thin: scaled to the first pick's Y", "from the stack's own two bands"]
set xlabel 'angle θ' textcolor rgb ink offset 0, 0.3
set format y '%g'
do for [panel = 1:3] {
    set lmargin at screen from[panel]
    set rmargin at screen from[panel] + 0.265
    set label 1 heading_of[panel] at graph 0, 1.16 textcolor rgb ink
    set label 2 remark[panel] at graph 0, 1.065 font note textcolor rgb faint
    unset ylabel
    if (panel == 1) {
        set yrange [*:*]
        set ytics autofreq
        plot for [i = count:1:-1] angles using 'angle_deg':(column(exact(i, 'nm'))) with lines linecolor rgb tint[i] linewidth weight[i], \
             angles using 'angle_deg':'palette_nm' with lines linecolor rgb ink linewidth 2.5
    }
    if (panel == 2) {
        set yrange [0:100]
        set ytics 20
        plot for [i = count:1:-1] angles using 'angle_deg':(column(exact(i, 'de00'))) with lines linecolor rgb tint[i] linewidth weight[i], \
             for [i = count:1:-1] angles using 'angle_deg':(column(exact(i, 'scaled_de00'))) with lines linecolor rgb tint[i] linewidth 1.5
    }
    if (panel == 3) {
        plot for [i = count:1:-1] angles using 'angle_deg':(column(exact(i, 'repicked_de00'))) with lines linecolor rgb tint[i] linewidth weight[i]
    }
    unset label
}
unset multiplot
