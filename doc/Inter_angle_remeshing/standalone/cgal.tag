<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- Where CGAL's manual explains what this package's refers to. -->
<tagfile>
  <compound kind="group">
    <name>bgl_namedparameters</name>
    <title>Named Parameters</title>
    <filename>BGL/group__bgl__namedparameters.html</filename>
  </compound>
  <compound kind="page">
    <name>thirdparty</name>
    <title>Essential and Optional Third Party Dependencies</title>
    <filename>Manual/thirdparty.html</filename>
    <docanchor file="Manual/thirdparty.html" title="Eigen">thirdpartyEigen</docanchor>
    <docanchor file="Manual/thirdparty.html" title="TBB">thirdpartyTBB</docanchor>
  </compound>
  <compound kind="page">
    <name>license</name>
    <title>License</title>
    <filename>Manual/license.html</filename>
    <docanchor file="Manual/license.html" title="GPL">licensesGPL</docanchor>
  </compound>
  <compound kind="namespace">
    <name>CGAL::Polygon_mesh_processing</name>
    <filename>Polygon_mesh_processing/index.html</filename>
    <member kind="function">
      <type>void</type>
      <name>isotropic_remeshing</name>
      <anchorfile>Polygon_mesh_processing/index.html</anchorfile>
      <anchor></anchor>
      <arglist>(const FaceRange &amp;faces, SizingFunction &amp;sizing, PolygonMesh &amp;pmesh, const NamedParameters &amp;np=parameters::default_values())</arglist>
    </member>
  </compound>
  <compound kind="class">
    <name>ConstRange</name>
    <filename>Circulator/classConstRange.html</filename>
  </compound>
  <compound kind="class">
    <name>Hashable</name>
    <filename>STL_Extension/classHashable.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceGraph</name>
    <filename>BGL/classFaceGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>FaceListGraph</name>
    <filename>BGL/classFaceListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>VertexListGraph</name>
    <filename>BGL/classVertexListGraph.html</filename>
  </compound>
  <compound kind="class">
    <name>MutableFaceGraph</name>
    <filename>BGL/classMutableFaceGraph.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Sequential_tag</name>
    <filename>STL_Extension/structCGAL_1_1Sequential__tag.html</filename>
  </compound>
  <compound kind="struct">
    <name>CGAL::Parallel_tag</name>
    <filename>STL_Extension/structCGAL_1_1Parallel__tag.html</filename>
  </compound>
</tagfile>
