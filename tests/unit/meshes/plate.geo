// A plate of 2 m x 1 m from two squares, "steel" on the left and "rubber" on
// the right: 4 x 2 cells, or with triangles:
//
//   gmsh -2 -format msh41 plate.geo -o plate_41.msh
//   gmsh -2 -format msh22 plate.geo -o plate_22.msh
//   gmsh -2 -format inp plate.geo -o plate_gmsh.inp
//   gmsh -2 -format msh41 plate.geo -setnumber triangles 1 -o triangles.msh
DefineConstant[triangles = 0];
Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {2, 0, 0};
Point(4) = {2, 1, 0};
Point(5) = {1, 1, 0};
Point(6) = {0, 1, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {2, 5};
Curve Loop(1) = {1, 7, 5, 6};
Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -7};
Plane Surface(2) = {2};
Transfinite Curve {1, 2, 3, 4, 5, 6, 7} = 3;
Transfinite Surface {1, 2};
If (!triangles)
  Recombine Surface {1, 2};
EndIf

Physical Curve("bottom") = {1, 2};
Physical Curve("right side") = {3};
Physical Curve("top") = {4, 5};
Physical Curve("left") = {6};
Physical Curve("interface") = {7};
Physical Surface("steel") = {1};
Physical Surface("rubber") = {2};
