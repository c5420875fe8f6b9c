MODULE short_weld_mod
  ! 5 points in 4.500 s, off the plan by 0.000 mm and 0.000 deg at most
  PROC short_weld()
    VelSet 10,5000;
    MoveAbsJ [[10.0000,-90.0000,100.0000,0.0000,45.0000,170.0000],[-1000.0000,9E9,9E9,9E9,9E9,9E9]]\NoEOffs,v1000,fine,tool0\WObj:=wobj0;
    VelSet 100,5000;
    MoveAbsJ [[11.0000,-91.0000,101.5000,0.2500,45.0000,170.0000],[0.0000,9E9,9E9,9E9,9E9,9E9]]\NoEOffs,v1000\T:=1.0000,z0,tool0\WObj:=wobj0;
    SetDO doWeld,1;
    MoveAbsJ [[12.0000,-92.0000,103.0000,0.5000,44.5000,171.0000],[12.5000,9E9,9E9,9E9,9E9,9E9]]\NoEOffs,v1000\T:=0.7500,z0,tool0\WObj:=wobj0;
    MoveAbsJ [[13.0000,-93.0000,104.5000,0.0000,44.0000,172.0000],[25.0000,9E9,9E9,9E9,9E9,9E9]]\NoEOffs,v1000\T:=1.2500,z0,tool0\WObj:=wobj0;
    SetDO doWeld,0;
    MoveAbsJ [[14.0000,-80.0000,90.0000,5.0000,40.0000,-172.1250],[30.0000,9E9,9E9,9E9,9E9,9E9]]\NoEOffs,v1000\T:=1.5000,fine,tool0\WObj:=wobj0;
  ENDPROC
ENDMODULE
