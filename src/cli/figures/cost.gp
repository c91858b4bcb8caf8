load 'style.gp'
set output name . '.png'
