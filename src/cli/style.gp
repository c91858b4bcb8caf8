# What every figure shares: terminal, letters, colours. The data are beside it, see README.md.
set encoding utf8
if (strstrt(GPVAL_TERMINALS, 'pngcairo') > 0) {
    set terminal pngcairo size 2400,1600 font 'DejaVu Sans,30' background rgb 'white' linewidth 2
} else {
    set terminal png truecolor size 2400,1600 font 'DejaVu Sans,30' background rgb 'white' linewidth 2
}
set datafile separator ','
set datafile columnheaders

ink = '#333333'
faint = '#8a8a8a'
rule = '#e4e4e4'
morpho = '#2b5fb0'
beetle = '#2a8a57'
accent = '#c4501b'
heading = ',36'
note = ',26'

set minussign
set border 3 back linecolor rgb faint linewidth 1.2
set tics nomirror out scale 0.6 textcolor rgb ink
set grid linetype 1 linecolor rgb rule linewidth 0.8
unset key
set style line 1 linecolor rgb morpho linewidth 3
set style line 2 linecolor rgb beetle linewidth 3
set style line 3 linecolor rgb accent linewidth 3
set style line 4 linecolor rgb ink linewidth 2
