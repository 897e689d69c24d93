//! Field → marks and stripe statistics, with the words of the contract.
