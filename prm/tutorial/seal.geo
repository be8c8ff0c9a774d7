// One half of a rubber cord, 6 mm thick, seen along the cord. Lengths in mm.
//
//   gmsh -2 -format msh22 seal.geo
R = 3;             // radius of the cord
c = 0.5*R;         // half the width of the square core
s = R*Sin(Pi/4);   // where the rays at 45 degrees meet the rim
n = 6;             // cells along half a side of the core
m = 6;             // cells from the core to the rim

Point(1) = {0, 0, 0};
// the core, on the plane of symmetry x = 0
Point(2) = {0, -c, 0};
Point(3) = {c, -c, 0};
Point(4) = {c, c, 0};
Point(5) = {0, c, 0};
// the rim
Point(6) = {0, -R, 0};
Point(7) = {s, -s, 0};
Point(8) = {s, s, 0};
Point(9) = {0, R, 0};

Line(1) = {2, 3};
Line(2) = {3, 4};
Line(3) = {4, 5};
Line(4) = {5, 2};
Circle(5) = {6, 1, 7};
Circle(6) = {7, 1, 8};
Circle(7) = {8, 1, 9};
Line(8) = {6, 2};
Line(9) = {7, 3};
Line(10) = {8, 4};
Line(11) = {9, 5};

Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Curve Loop(2) = {5, 9, -1, -8};
Plane Surface(2) = {2};
Curve Loop(3) = {6, 10, -2, -9};
Plane Surface(3) = {3};
Curve Loop(4) = {7, 11, -3, -10};
Plane Surface(4) = {4};

// Blocks of quadrilaterals, which meet node by node.
Transfinite Curve {1, 3, 5, 7} = n + 1;
Transfinite Curve {2, 4, 6} = 2*n + 1;
Transfinite Curve {8, 9, 10, 11} = m + 1;
Transfinite Surface {1, 2, 3, 4};
Recombine Surface {1, 2, 3, 4};

// The names that the .prm uses.
Physical Curve("rim") = {5, 6, 7};
Physical Curve("middle") = {4, 8, 11};
Physical Surface("cord") = {1, 2, 3, 4};
