/PROG  SHORT_WELD
/ATTR
OWNER		= MNEDITOR;
COMMENT		= "wristwise";
PROG_SIZE	= 0;
FILE_NAME	= ;
VERSION		= 0;
LINE_COUNT	= 11;
MEMORY_SIZE	= 0;
PROTECT		= READ_WRITE;
TCD:  STACK_SIZE	= 0,
      TASK_PRIORITY	= 50,
      TIME_SLICE	= 0,
      BUSY_LAMP_OFF	= 0,
      ABORT_REQUEST	= 0,
      PAUSE_REQUEST	= 0;
DEFAULT_GROUP	= 1,*,*,*,*;
CONTROL_CODE	= 00000000 00000000;
/MN
   1:  !5 points ;
   2:  !off the plan by 0.000 mm ;
   3:  UFRAME_NUM=0 ;
   4:  UTOOL_NUM=1 ;
   5:J P[1] 10% FINE    ;
   6:J P[2] 1000msec CNT100    ;
   7:  Arc Start[1] ;
   8:J P[3] 750msec CNT100    ;
   9:J P[4] 1250msec CNT100    ;
  10:  Arc End[1] ;
  11:J P[5] 1500msec FINE    ;
/POS
P[1]{
   GP1:
	UF : 0, UT : 1,
	J1=     10.0000 deg,	J2=    -90.0000 deg,	J3=    190.0000 deg,
	J4=      0.0000 deg,	J5=     45.0000 deg,	J6=    170.0000 deg,
	E1=  -1000.0000  mm
};
P[2]{
   GP1:
	UF : 0, UT : 1,
	J1=     11.0000 deg,	J2=    -91.0000 deg,	J3=    192.5000 deg,
	J4=      0.2500 deg,	J5=     45.0000 deg,	J6=    170.0000 deg,
	E1=      0.0000  mm
};
P[3]{
   GP1:
	UF : 0, UT : 1,
	J1=     12.0000 deg,	J2=    -92.0000 deg,	J3=    195.0000 deg,
	J4=      0.5000 deg,	J5=     44.5000 deg,	J6=    171.0000 deg,
	E1=     12.5000  mm
};
P[4]{
   GP1:
	UF : 0, UT : 1,
	J1=     13.0000 deg,	J2=    -93.0000 deg,	J3=    197.5000 deg,
	J4=      0.0000 deg,	J5=     44.0000 deg,	J6=    172.0000 deg,
	E1=     25.0000  mm
};
P[5]{
   GP1:
	UF : 0, UT : 1,
	J1=     14.0000 deg,	J2=    -80.0000 deg,	J3=    170.0000 deg,
	J4=      5.0000 deg,	J5=     40.0000 deg,	J6=   -172.1250 deg,
	E1=     30.0000  mm
};
/END
