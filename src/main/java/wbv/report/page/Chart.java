package wbv.report.page;

/** A drawing over two axes. Charts of one group pan and zoom together along x; those that follow each other are set as one. */
public sealed interface Chart extends Block permits LineChart, XyChart, BarChart, Heatmap {

    String title();

    ChartAxis x();

    ChartAxis y();

    /** Name of the group of charts that share x; empty if none. */
    String group();

    /** What the reader should know about it, below the chart; may be empty. */
    String note();
}
