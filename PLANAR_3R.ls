/PROG  PLANAR_3R
/ATTR
OWNER		= MNEDITOR;
COMMENT		= "wristwise";
PROG_SIZE	= 0;
FILE_NAME	= ;
VERSION		= 0;
LINE_COUNT	= 46;
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
   1:  !40 points ;
   2:  !off the plan by 0.000 mm ;
   3:  UFRAME_NUM=0 ;
   4:  UTOOL_NUM=1 ;
   5:J P[1] 10% FINE    ;
   6:  Arc Start[1] ;
   7:J P[2] 410msec CNT100    ;
   8:J P[3] 411msec CNT100    ;
   9:J P[4] 410msec CNT100    ;
  10:J P[5] 410msec CNT100    ;
  11:J P[6] 410msec CNT100    ;
  12:J P[7] 411msec CNT100    ;
  13:J P[8] 410msec CNT100    ;
  14:J P[9] 410msec CNT100    ;
  15:J P[10] 410msec CNT100    ;
  16:J P[11] 411msec CNT100    ;
  17:J P[12] 410msec CNT100    ;
  18:J P[13] 410msec CNT100    ;
  19:J P[14] 410msec CNT100    ;
  20:J P[15] 411msec CNT100    ;
  21:J P[16] 410msec CNT100    ;
  22:J P[17] 410msec CNT100    ;
  23:J P[18] 410msec CNT100    ;
  24:J P[19] 411msec CNT100    ;
  25:J P[20] 410msec CNT100    ;
  26:J P[21] 410msec CNT100    ;
  27:J P[22] 410msec CNT100    ;
  28:J P[23] 411msec CNT100    ;
  29:J P[24] 410msec CNT100    ;
  30:J P[25] 410msec CNT100    ;
  31:J P[26] 410msec CNT100    ;
  32:J P[27] 411msec CNT100    ;
  33:J P[28] 410msec CNT100    ;
  34:J P[29] 410msec CNT100    ;
  35:J P[30] 410msec CNT100    ;
  36:J P[31] 411msec CNT100    ;
  37:J P[32] 410msec CNT100    ;
  38:J P[33] 410msec CNT100    ;
  39:J P[34] 410msec CNT100    ;
  40:J P[35] 411msec CNT100    ;
  41:J P[36] 410msec CNT100    ;
  42:J P[37] 410msec CNT100    ;
  43:J P[38] 410msec CNT100    ;
  44:J P[39] 411msec CNT100    ;
  45:J P[40] 410msec FINE    ;
  46:  Arc End[1] ;
/POS
P[1]{
   GP1:
	UF : 0, UT : 1,
	J1=    -67.1226 deg,	J2=     95.3561 deg,	J3=   -163.5897 deg
};
P[2]{
   GP1:
	UF : 0, UT : 1,
	J1=    -65.9552 deg,	J2=     96.8999 deg,	J3=   -167.8445 deg
};
P[3]{
   GP1:
	UF : 0, UT : 1,
	J1=    -64.6883 deg,	J2=     98.3268 deg,	J3=   -171.9653 deg
};
P[4]{
   GP1:
	UF : 0, UT : 1,
	J1=    -63.3241 deg,	J2=     99.6367 deg,	J3=   -175.9492 deg
};
P[5]{
   GP1:
	UF : 0, UT : 1,
	J1=    -61.8654 deg,	J2=    100.8289 deg,	J3=   -179.7923 deg
};
P[6]{
   GP1:
	UF : 0, UT : 1,
	J1=    -60.3154 deg,	J2=    101.9026 deg,	J3=   -183.4899 deg
};
P[7]{
   GP1:
	UF : 0, UT : 1,
	J1=    -58.6776 deg,	J2=    102.8570 deg,	J3=   -187.0363 deg
};
P[8]{
   GP1:
	UF : 0, UT : 1,
	J1=    -56.9563 deg,	J2=    103.6908 deg,	J3=   -190.4254 deg
};
P[9]{
   GP1:
	UF : 0, UT : 1,
	J1=    -55.1558 deg,	J2=    104.4032 deg,	J3=   -193.6506 deg
};
P[10]{
   GP1:
	UF : 0, UT : 1,
	J1=    -53.2811 deg,	J2=    104.9930 deg,	J3=   -196.7049 deg
};
P[11]{
   GP1:
	UF : 0, UT : 1,
	J1=    -51.3376 deg,	J2=    105.4594 deg,	J3=   -199.5811 deg
};
P[12]{
   GP1:
	UF : 0, UT : 1,
	J1=    -49.3308 deg,	J2=    105.8014 deg,	J3=   -202.2720 deg
};
P[13]{
   GP1:
	UF : 0, UT : 1,
	J1=    -47.2667 deg,	J2=    106.0186 deg,	J3=   -204.7705 deg
};
P[14]{
   GP1:
	UF : 0, UT : 1,
	J1=    -45.1513 deg,	J2=    106.1106 deg,	J3=   -207.0698 deg
};
P[15]{
   GP1:
	UF : 0, UT : 1,
	J1=    -42.9906 deg,	J2=    106.0770 deg,	J3=   -209.1635 deg
};
P[16]{
   GP1:
	UF : 0, UT : 1,
	J1=    -40.7906 deg,	J2=    105.9181 deg,	J3=   -211.0456 deg
};
P[17]{
   GP1:
	UF : 0, UT : 1,
	J1=    -38.5573 deg,	J2=    105.6341 deg,	J3=   -212.7110 deg
};
P[18]{
   GP1:
	UF : 0, UT : 1,
	J1=    -36.2962 deg,	J2=    105.2256 deg,	J3=   -214.1550 deg
};
P[19]{
   GP1:
	UF : 0, UT : 1,
	J1=    -34.0126 deg,	J2=    104.6932 deg,	J3=   -215.3737 deg
};
P[20]{
   GP1:
	UF : 0, UT : 1,
	J1=    -31.7113 deg,	J2=    104.0377 deg,	J3=   -216.3642 deg
};
P[21]{
   GP1:
	UF : 0, UT : 1,
	J1=    -29.3967 deg,	J2=    103.2603 deg,	J3=   -217.1239 deg
};
P[22]{
   GP1:
	UF : 0, UT : 1,
	J1=    -27.0728 deg,	J2=    102.3619 deg,	J3=   -217.6510 deg
};
P[23]{
   GP1:
	UF : 0, UT : 1,
	J1=    -24.7427 deg,	J2=    101.3436 deg,	J3=   -217.9446 deg
};
P[24]{
   GP1:
	UF : 0, UT : 1,
	J1=    -22.4093 deg,	J2=    100.2065 deg,	J3=   -218.0037 deg
};
P[25]{
   GP1:
	UF : 0, UT : 1,
	J1=    -20.0745 deg,	J2=     98.9513 deg,	J3=   -217.8281 deg
};
P[26]{
   GP1:
	UF : 0, UT : 1,
	J1=    -17.7399 deg,	J2=     97.5788 deg,	J3=   -217.4178 deg
};
P[27]{
   GP1:
	UF : 0, UT : 1,
	J1=    -15.4064 deg,	J2=     96.0895 deg,	J3=   -216.7725 deg
};
P[28]{
   GP1:
	UF : 0, UT : 1,
	J1=    -13.0744 deg,	J2=     94.4833 deg,	J3=   -215.8923 deg
};
P[29]{
   GP1:
	UF : 0, UT : 1,
	J1=    -10.7435 deg,	J2=     92.7600 deg,	J3=   -214.7765 deg
};
P[30]{
   GP1:
	UF : 0, UT : 1,
	J1=     -8.4130 deg,	J2=     90.9186 deg,	J3=   -213.4243 deg
};
P[31]{
   GP1:
	UF : 0, UT : 1,
	J1=     -6.0813 deg,	J2=     88.9576 deg,	J3=   -211.8339 deg
};
P[32]{
   GP1:
	UF : 0, UT : 1,
	J1=     -3.7466 deg,	J2=     86.8747 deg,	J3=   -210.0028 deg
};
P[33]{
   GP1:
	UF : 0, UT : 1,
	J1=     -1.4060 deg,	J2=     84.6666 deg,	J3=   -207.9271 deg
};
P[34]{
   GP1:
	UF : 0, UT : 1,
	J1=      0.9437 deg,	J2=     82.3288 deg,	J3=   -205.6013 deg
};
P[35]{
   GP1:
	UF : 0, UT : 1,
	J1=      3.3065 deg,	J2=     79.8557 deg,	J3=   -203.0180 deg
};
P[36]{
   GP1:
	UF : 0, UT : 1,
	J1=      3.9465 deg,	J2=     80.6950 deg,	J3=   -200.3365 deg
};
P[37]{
   GP1:
	UF : 0, UT : 1,
	J1=      4.5274 deg,	J2=     81.4076 deg,	J3=   -197.3427 deg
};
P[38]{
   GP1:
	UF : 0, UT : 1,
	J1=      5.0524 deg,	J2=     81.9840 deg,	J3=   -194.0203 deg
};
P[39]{
   GP1:
	UF : 0, UT : 1,
	J1=      5.5261 deg,	J2=     82.4129 deg,	J3=   -190.3519 deg
};
P[40]{
   GP1:
	UF : 0, UT : 1,
	J1=      5.9554 deg,	J2=     82.6818 deg,	J3=   -186.3190 deg
};
/END
