// The bytes of template.html, as they are.
    .section .rodata
    .hidden wristwise_page_template
    .hidden wristwise_page_template_end
    .global wristwise_page_template
    .global wristwise_page_template_end
wristwise_page_template:
    .incbin WRISTWISE_PAGE_TEMPLATE
wristwise_page_template_end:
    .byte 0
    .section .note.GNU-stack,"",%progbits
