package wbv.report;

/** Something on a page: words, numbers in a row or in a table, findings, or a chart. */
public sealed interface Block permits Text, Code, Table, Figures, Findings, Chart { }
