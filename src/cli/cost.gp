# Time against error on two logarithmic scales: down is faster, left is more exact. Thick lines and large points are all
# that a way takes; thin ones are computing alone.
load 'style.gp'
set output name . '.png'
data = name . '.csv'

fixed = '#7d8ca3'
all(x) = 1e3 * column('all_seconds')
computing(x) = 1e3 * column('computing_seconds')
is(family, axis, format) = strcol('family') eq family && (axis eq '' || strcol('axis') eq axis) && (format eq '' || strcol('format') eq format)
pick(family, axis, format) = is(family, axis, format) ? column('de00') : NaN
# Choices that came out alike are one point.
choice(x) = strcol('family') eq 'choice' && strcol('mark') ne '=' ? column('de00') : NaN
# Names stand to the right of their points, but where others lie there.
left_of = 'exact integral, chosen nodes, Wyman fit at 5 nm'
last = 'three wavelengths'
right(x) = strcol('family') eq 'integral' && strstrt(left_of . last, strcol('label')) == 0 ? column('de00') : NaN
left(x) = strcol('family') eq 'integral' && strstrt(left_of, strcol('label')) > 0 ? column('de00') : NaN
below(x) = strcol('family') eq 'integral' && strcol('label') eq last ? column('de00') : NaN
# "5 nm sum" is "5 nm" here.
shorter(text) = strstrt(text, ' sum') > 0 ? text[1 : strlen(text) - 4] : strstrt(text, 'single') > 0 ? 'single-lobe fit' : text
end(axis) = is('fixed_size', axis, 'half') && column('width') == 32 ? column('de00') : NaN

# The range of the data, with room for words; errors of nothing (a black LUT) stay out.
stats data using (column('de00') > 1e-6 && strcol('family') ne 'mistake' ? log10(column('de00')) : NaN) name 'E' nooutput
stats data using (log10(computing(0))) name 'C' nooutput
stats data using (log10(all(0))) name 'A' nooutput
set xrange [10**(E_min - 0.7) : 10**(E_max + 0.6)]
set yrange [10**(C_min - 0.3) : 10**(A_max + 0.3)]
set logscale xy
set format x '%g'
set format y '%g'
set lmargin 9
set rmargin 2
set tmargin 7.5
set bmargin 4
set xlabel 'largest colour error of what a shader fetches (CIEDE2000; 1 can just be seen)' textcolor rgb ink
set ylabel 'time of one thread (ms)' textcolor rgb ink offset 0.5, 0
set label 1 'What accuracy costs: the LUT ' . title at graph 0, 1.195 font heading textcolor rgb ink noenhanced
set label 2 'thick: computing, deciding and measuring' at graph 0, 1.085 font note textcolor rgb faint
set label 7 'thin: computing alone' at graph 0, 1.035 font note textcolor rgb faint
set label 4 "nacre's own choice, and beside it the bound that was asked for" at graph 1, 1.135 right font note textcolor rgb morpho
set label 5 'sizes fixed by hand, 32 to 1024 texels, in half and float, and checked' at graph 1, 1.085 right font note textcolor rgb fixed
set label 6 "1024 texels by other integrals: sums, shaders' fits, three wavelengths; checked" at graph 1, 1.035 right font note textcolor rgb accent

set arrow 1 from bound, graph 0 to bound, graph 1 nohead linecolor rgb ink linewidth 2 dashtype 2 back
set label 3 sprintf('the bound, %g', bound) at bound, graph 0.965 offset 0.6, 0 font note textcolor rgb ink
array axes[3] = ['sqrt_cos_theta', 'cos_theta', 'theta_deg']
array dash[3] = [1, 2, 4]

plot for [i = 1:3] for [f in 'half float'] data using (pick('fixed_size', axes[i], f)):(computing(0)) with lines linecolor rgb fixed linewidth 1 dashtype dash[i], \
     for [i = 1:3] for [f in 'half float'] data using (pick('fixed_size', axes[i], f)):(all(0)) with linespoints linecolor rgb fixed linewidth 3 dashtype dash[i] pointtype 7 pointsize 0.9, \
     data using (end('sqrt_cos_theta')):(computing(0)):('over √cosθ') with labels left offset 1, -0.1 font note textcolor rgb fixed, \
     data using (end('cos_theta')):(computing(0)):('over cosθ') with labels center offset 0, -1 font note textcolor rgb fixed, \
     data using (end('theta_deg')):(computing(0)):('over θ') with labels left offset 0.6, 0.8 font note textcolor rgb fixed, \
     data using (pick('integral', '', '')):(computing(0)) with points pointtype 4 pointsize 1 linecolor rgb accent, \
     data using (pick('integral', '', '')):(all(0)) with points pointtype 5 pointsize 2 linecolor rgb accent, \
     data using (right(0)):(computing(0)):(shorter(strcol('label'))) with labels left offset 0.8, 0 font note textcolor rgb accent noenhanced, \
     data using (left(0)):(computing(0)):(strcol('label')) with labels right offset -0.8, 0 font note textcolor rgb accent noenhanced, \
     data using (below(0)):(computing(0)):(last) with labels center offset 0, -0.9 font note textcolor rgb accent noenhanced, \
     data using (pick('choice', '', '')):(computing(0)) with lines linecolor rgb morpho linewidth 1.5, \
     data using (pick('choice', '', '')):(all(0)) with lines linecolor rgb morpho linewidth 5, \
     data using (choice(0)):(all(0)) with points linecolor rgb morpho pointtype 7 pointsize 3, \
     data using (choice(0)):(all(0)):(strcol('mark')) with labels center offset 0, 1.1 font note textcolor rgb morpho noenhanced
