// A beam, 0.2 m long and 0.02 m high, with 80 x 8 equal rectangles.
//
//   gmsh -2 -format msh41 beam.geo
length = 0.2;
height = 0.02;

Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
Point(3) = {length, height, 0};
Point(4) = {0, height, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

// All quadrilaterals: structured, and triangles recombined in pairs.
Transfinite Curve {1, 3} = 81;
Transfinite Curve {2, 4} = 9;
Transfinite Surface {1};
Recombine Surface {1};

// The names that the .prm uses.
Physical Curve("bottom") = {1};
Physical Curve("right") = {2};
Physical Curve("top") = {3};
Physical Curve("left") = {4};
Physical Surface("beam") = {1};
