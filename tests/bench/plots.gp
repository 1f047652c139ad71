# Run in the folder with the data: gnuplot /path/to/plots.gp. Draws each plot, as SVG and PNG,
# whose data are there.
load "machine.ini"
is_there(file) = int(system("test -f ".file." && echo 1 || echo 0"))
if (is_there("growth.ini")) { load "growth.ini" }
set encoding utf8
set logscale xy
set format y "10^{%L}"
set grid xtics ytics lt 1 lw 1 lc rgb "#dddddd"
set key box opaque
set pointsize 0.9
set rmargin 5

fit_line(slope) = sprintf("fit: slope %.2f", slope)

do for [kind in "svg png"] {
    if (kind eq "svg") { set terminal svg size 720,480 font "sans,13" background "white" } else { set terminal pngcairo size 1080,720 font "sans,17" }

    if (is_there("bodies-discs.dat") && is_there("bodies-pentagons.dat") && is_there("growth.ini")) {
    set output "bodies.".kind
    set title "Speed against the number of bodies, packing 0.3\n{/*0.8 ".machine.", one core}"
    set xlabel "bodies"
    set format x "10^{%L}"
    set ylabel "collisions a second"
    set key top right
    set yrange [1e4:1e7]
    set xrange [*:*]
    plot "bodies-discs.dat" using 1:2 with points pt 7 lc rgb "#1f77b4" title "discs", \
         factor_bodies_discs * x**slope_bodies_discs lc rgb "#1f77b4" dt 2 title fit_line(slope_bodies_discs), \
         "bodies-pentagons.dat" using 1:2 with points pt 5 lc rgb "#d62728" title "pentagons", \
         factor_bodies_pentagons * x**slope_bodies_pentagons lc rgb "#d62728" dt 2 title fit_line(slope_bodies_pentagons)
    }

    if (is_there("vertices.dat") && is_there("growth.ini")) {
    set output "vertices.".kind
    set title "Speed against the number of vertices, 200 regular polygons, packing 0.2\n{/*0.8 ".machine.", one core}"
    set xlabel "vertices of each polygon"
    set format x "%g"
    set yrange [*:*]
    set xrange [2:120]
    plot "vertices.dat" using 1:2 with points pt 5 lc rgb "#d62728" title "regular polygons", \
         factor_vertices * x**slope_vertices lc rgb "#d62728" dt 2 title fit_line(slope_vertices), \
         [20:100] end_factor_vertices * x**end_slope_vertices lc rgb "#7f0000" lw 2 \
             title "upper half, ".fit_line(end_slope_vertices)
    }
}
unset output
