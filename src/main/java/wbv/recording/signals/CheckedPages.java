package wbv.recording.signals;

import org.apache.parquet.column.ColumnDescriptor;
import org.apache.parquet.column.page.DataPage;
import org.apache.parquet.column.page.DictionaryPage;
import org.apache.parquet.column.page.PageReadStore;
import org.apache.parquet.column.page.PageReader;
import wbv.recording.DataFault;

/** The pages of a group of rows, of which none states more values than it can hold: room is made for them before they are read. */
record CheckedPages(String file, PageReadStore pages) implements PageReadStore {

    @Override
    public PageReader getPageReader(ColumnDescriptor column) {
        PageReader reader = pages.getPageReader(column);
        require(reader.getTotalValueCount() == getRowCount(), column);
        return new PageReader() {
            @Override
            public DictionaryPage readDictionaryPage() {
                DictionaryPage page = reader.readDictionaryPage();
                if (page != null) { // as Parquet says that there is none
                    require(page.getDictionarySize() >= 0 && page.getDictionarySize() <= page.getBytes().size(), column);
                }
                return page;
            }

            @Override
            public long getTotalValueCount() {
                return reader.getTotalValueCount();
            }

            @Override
            public DataPage readPage() {
                DataPage page = reader.readPage();
                require(page != null && page.getValueCount() > 0 && page.getValueCount() <= getRowCount(), column);
                return page;
            }
        };
    }

    private void require(boolean sound, ColumnDescriptor column) {
        if (!sound) {
            throw DataFault.in(file,
                    "the column '" + String.join(".", column.getPath()) + "' states another number of values than it holds; "
                            + "the file is damaged");
        }
    }

    @Override
    public long getRowCount() {
        return pages.getRowCount();
    }
}
