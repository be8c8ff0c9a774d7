// A brick of 1 m x 2 m x 3 m with 1 x 2 x 3 cells:
//
//   gmsh -3 -format msh41 brick.geo -o brick.msh
//   gmsh -3 -format inp brick.geo -o brick_gmsh.inp
Point(1) = {0, 0, 0};
edge[] = Extrude {1, 0, 0} { Point{1}; Layers{1}; };
base[] = Extrude {0, 2, 0} { Curve{edge[1]}; Layers{2}; Recombine; };
brick[] = Extrude {0, 0, 3} { Surface{base[1]}; Layers{3}; Recombine; };

Physical Surface("back") = {base[1]};
Physical Surface("front") = {brick[0]};
Physical Surface("bottom") = {brick[2]};
Physical Volume("brick") = {brick[1]};
