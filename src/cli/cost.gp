# Time against error on two logarithmic scales: down is faster, left is more exact.
load 'style.gp'
set output name . '.png'
data = name . '.csv'

fixed = '#7d8ca3'
us(seconds) = 1e6 * seconds
is(family, axis, format) = strcol('family') eq family && (axis eq '' || strcol('axis') eq axis) && (format eq '' || strcol('format') eq format)
pick(family, axis, format) = is(family, axis, format) ? column('de00') : NaN
# Choices that came out alike are one point.
choice(x) = strcol('family') eq 'choice' && strcol('mark') ne '=' ? column('de00') : NaN
# Names stand above their points, but where others already do. "5 nm sum" is "5 nm" here.
beside = 'fast integral Wyman single-lobe fit at 5 nm'
above(x) = strcol('family') eq 'integral' && strstrt(beside, strcol('label')) == 0 ? column('de00') : NaN
right_of(label) = strcol('family') eq 'integral' && strcol('label') eq label ? column('de00') : NaN
shorter(text) = strstrt(text, ' sum') > 0 ? text[1 : strlen(text) - 4] : text
end(axis) = is('fixed_size', axis, 'half') && column('width') == 32 ? column('de00') : NaN

# The range of the data, with room for words; errors of nothing (a black LUT) stay out.
stats data using (column('de00') > 1e-6 && strcol('family') ne 'mistake' ? log10(column('de00')) : NaN) name 'E' nooutput
stats data using (log10(us(column('seconds')))) name 'T' nooutput
set xrange [10**(E_min - 0.7) : 10**(E_max + 0.5)]
set yrange [10**(T_min - 0.3) : 10**(T_max + 0.3)]
set logscale xy
set format x '%g'
set format y '%g'
set lmargin 8
set rmargin 2
set tmargin 6
set bmargin 4
set xlabel 'largest colour error of what a shader fetches (CIEDE2000; 1 can just be seen)' textcolor rgb ink
set ylabel 'time to compute the texels, one thread (µs)' textcolor rgb ink offset 0.5, 0
set label 1 'What accuracy costs: the LUT ' . title at graph 0, 1.13 font heading textcolor rgb ink noenhanced
set label 2 'down is faster, left is more exact' at graph 0, 1.075 font note textcolor rgb faint
set label 4 "nacre's own choice, and beside it the bound that was asked for" at graph 1, 1.135 right font note textcolor rgb morpho
set label 5 'sizes fixed by hand, 32 to 1024 texels: half stops where its rounding rules, float goes on' at graph 1, 1.085 right font note textcolor rgb fixed
set label 6 "1024 texels by sums over every 1 to 20 nm, shaders' fits, three wavelengths" at graph 1, 1.035 right font note textcolor rgb accent

set arrow 1 from bound, graph 0 to bound, graph 1 nohead linecolor rgb ink linewidth 2 dashtype 2 back
set label 3 sprintf('the bound, %g', bound) at bound, graph 0.965 offset 0.6, 0 font note textcolor rgb ink
array axes[3] = ['sqrt_cos_theta', 'cos_theta', 'theta_deg']
array dash[3] = [1, 2, 4]

plot for [i = 1:3] for [f in 'half float'] data using (pick('fixed_size', axes[i], f)):(us(column('seconds'))) with linespoints linecolor rgb fixed linewidth 2 dashtype dash[i] pointtype 7 pointsize 0.9, \
     data using (end('sqrt_cos_theta')):(us(column('seconds'))):('over √cosθ') with labels left offset 1, -0.1 font note textcolor rgb fixed, \
     data using (end('cos_theta')):(us(column('seconds'))):('over cosθ') with labels center offset 0, -1 font note textcolor rgb fixed, \
     data using (end('theta_deg')):(us(column('seconds'))):('over θ') with labels left offset 0.6, 0.8 font note textcolor rgb fixed, \
     data using (pick('integral', '', '')):(us(column('seconds'))) with points pointtype 5 pointsize 2 linecolor rgb accent, \
     data using (above(0)):(us(column('seconds'))):(shorter(strcol('label'))) with labels center offset 0, 1 font note textcolor rgb accent noenhanced, \
     data using (right_of('fast integral')):(us(column('seconds'))):(strcol('label')) with labels left offset 1.4, -0.3 font note textcolor rgb accent noenhanced, \
     data using (right_of('Wyman single-lobe fit at 5 nm')):(us(column('seconds'))):('single-lobe fit') with labels left offset 1.2, 0 font note textcolor rgb accent noenhanced, \
     data using (pick('choice', '', '')):(us(column('seconds'))) with lines linecolor rgb morpho linewidth 5, \
     data using (choice(0)):(us(column('seconds'))) with points linecolor rgb morpho pointtype 7 pointsize 3, \
     data using (choice(0)):(us(column('seconds'))):(strcol('mark')) with labels right offset -1, -0.9 font note textcolor rgb morpho noenhanced
