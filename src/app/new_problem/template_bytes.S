// The bytes of template.yaml, as they are.
    .section .rodata
    .hidden wristwise_problem_template
    .hidden wristwise_problem_template_end
    .global wristwise_problem_template
    .global wristwise_problem_template_end
wristwise_problem_template:
    .incbin WRISTWISE_PROBLEM_TEMPLATE
wristwise_problem_template_end:
    .byte 0
    .section .note.GNU-stack,"",%progbits
