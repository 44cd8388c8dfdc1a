package wbv.report.page;

/**
 * Something on a page: words, numbers in a row or in a table, findings, a graph, a chart, a figure, or several of these side
 * by side or folded.
 */
public sealed interface Block permits Lead, Text, Code, Table, Figures, Findings, Beside, StateGraph, Chart, Tiles, Folded,
        SensorFigure {}
