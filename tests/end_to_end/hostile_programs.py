"""Programs that no picture and no page may trip over."""
HOSTILE = ("PARTNO <script>window.hacked=1</script></title><img src=x onerror='window.hacked=1'> \x01 \u202e\n"
           "P1=POINT/1,2\nFROM/P1\nGOTO/</script><b>,2\nGOTO/5,6,7\nFINI\n")
BROKEN = "UNITS/MM\nP1=POINT/1,1\nC1=CIRCLE/QQ,1,1\nCUTTER/2\nFROM/P1\nGOTO/20,1\nGOTO/C1\nGOTO/20,20\nFINI\n"
