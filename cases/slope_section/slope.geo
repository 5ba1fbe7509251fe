<?xml version="1.0"?>
<!-- A slope of rock with a joint that dips out of its face, a tension crack behind the crest, two cross joints in the
     loose part and a joint that ends in the rock below. Lines may reach too far. [m] -->
<DDA>
<Geometry>
  <Edgenodedist distance="0.001"/>
  <Jointlist>
    <Joint type="1">  0    0      40    0     </Joint>
    <Joint type="1"> 40    0      40   20     </Joint>
    <Joint type="1"> 40   20      20   20     </Joint>
    <Joint type="1"> 20   20      10    5     </Joint>
    <Joint type="1"> 10    5       0    5     </Joint>
    <Joint type="1">  0    5       0    0     </Joint>
    <Joint type="1"> 11    7.29979  27   18.50311 </Joint>
    <Joint type="1"> 26   20.5    26   17     </Joint>
    <Joint type="1"> 18   11.9    13   19     </Joint>
    <Joint type="1"> 22.5 14.6    17.5 21.7   </Joint>
    <Joint type="1"> 25    5      32    9     </Joint>
  </Jointlist>
  <Fixedpointlist>
    <Line> 1 1  39 1 </Line>
  </Fixedpointlist>
  <Measuredpointlist>
    <Point> 22 18 </Point>
  </Measuredpointlist>
</Geometry>
</DDA>
